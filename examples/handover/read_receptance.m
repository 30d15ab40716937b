% Reads receptance.csv of mpsolve into MATLAB or Octave: K(j, i) is the receptance at omega(j) and xi(i).
%
%   [omega, xi, K] = read_receptance('receptance.csv')
%
% A force of 1 that moves along at xi = 0 as exp(1i*omega*tau) deflects the beam by 4/pi*K*exp(1i*omega*tau), in units of
% the static deflection w_st. Between the frequencies, use interp1(omega, K, ...).
function [omega, xi, K] = read_receptance(file)
  stream = fopen(file);
  names = strsplit(strtrim(fgetl(stream)), ',');
  fclose(stream);
  xi = cellfun(@(name) sscanf(name, 're_K(%f)'), names(2:2:end));
  table = dlmread(file, ',', 1, 0);
  omega = table(:, 1);
  K = complex(table(:, 2:2:end), table(:, 3:2:end));
end
