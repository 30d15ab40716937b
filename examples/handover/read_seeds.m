% Reads seeds.csv of mpsolve into MATLAB or Octave, and refines each seed by Newton's method on your own function.
%
%   roots = read_seeds('seeds.csv', @delta)     with delta(q, alpha, eta_b, eta_m, d)
%
% Each seed lies within abs(q)*1e-15 of a certified root; from any start within `radius` of it, Newton's method converges
% to that root and to no other.
function roots = read_seeds(file, delta)
  stream = fopen(file);
  names = strsplit(strtrim(fgetl(stream)), ',');
  cells = textscan(stream, repmat('%s', 1, numel(names)), 'Delimiter', ',');
  fclose(stream);
  % parameters are exact ratios such as 67/100, roots are decimals
  column = @(name) cellfun(@(text) str2num(text), cells{strcmp(names, name)}); %#ok<ST2NM>
  alpha = column('alpha'); eta_b = column('eta_b'); eta_m = column('eta_m'); d = column('d');
  roots = complex(column('q_re'), column('q_im'));
  for k = 1:numel(roots)
    f = @(q) delta(q, alpha(k), eta_b(k), eta_m(k), d(k));
    q = roots(k);
    for step = 1:5
      q = q - f(q) * 2e-7 / (f(q + 1e-7) - f(q - 1e-7));
    end
    roots(k) = q;
  end
end
