% Reads receptance.csv of mpsolve into MATLAB or Octave: G(j, i) is the receptance at omega(j) and xi(i).
%
%   [omega, xi, G] = read_receptance('receptance.csv')
%
% A force exp(1i*omega*t) that moves along deflects the rail at the distance xi ahead of it by G*exp(1i*omega*t), in the
% units of the track. Between the frequencies, use interp1(omega, G, ...).
function [omega, xi, G] = read_receptance(file)
  stream = fopen(file);
  names = strsplit(strtrim(fgetl(stream)), ',');
  fclose(stream);
  xi = cellfun(@(name) sscanf(name, 're_G(%f)'), names(2:2:end));
  table = dlmread(file, ',', 1, 0);
  omega = table(:, 1);
  G = complex(table(:, 2:2:end), table(:, 3:2:end));
end
