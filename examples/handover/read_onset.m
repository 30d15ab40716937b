% Reads onset.json, which `mpsolve onset CASE.toml --json > onset.json` wrote, into MATLAB or Octave.
%
%   [alpha, q] = read_onset('onset.json')       first unstable velocity ratio, and the root +-q that turns unstable there
%
% Both are proved to 16 digits; they are empty where no onset was found in the range (see answer.kind, reason).
function [alpha, q] = read_onset(file)
  answer = jsondecode(fileread(file));
  alpha = []; q = [];
  if strcmp(answer.answer.kind, 'crosses')
    alpha = str2double(answer.answer.value.decimal);
    q = str2double(answer.answer.q.decimal);
  end
end
