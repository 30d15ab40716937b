% Reads seeds.csv of mpsolve into MATLAB, and refines each seed by Newton's method on your own function.
%
%   roots = read_seeds('seeds.csv', @delta)     with delta(q, alpha, eta_b, eta_m, d)
%
% Each seed lies within abs(q)*1e-15 of a certified root; from any start within `radius` of it, Newton's method converges
% to that root and to no other.
function roots = read_seeds(file, delta)
  table = readtable(file, 'Delimiter', ',', 'TextType', 'string');
  number = @(text) str2num(char(text)); %#ok<ST2NM>  exact ratios such as 67/100
  roots = complex(zeros(height(table), 1));
  for k = 1:height(table)
    f = @(q) delta(q, number(table.alpha(k)), number(table.eta_b(k)), number(table.eta_m(k)), number(table.d(k)));
    q = complex(table.q_re(k), table.q_im(k));
    for step = 1:5
      q = q - f(q) * 2e-7 / (f(q + 1e-7) - f(q - 1e-7));
    end
    roots(k) = q;
  end
end
