# Reads receptance.csv of mpsolve into Maple: a table with K[x][j], the receptance at xi = x and omega[j].
# A force of 1 that moves along at xi = 0 as exp(I*omega*tau) deflects the beam by 4/Pi*K*exp(I*omega*tau), in units of the
# static deflection w_st. Between the frequencies, use CurveFitting:-Spline(omega, map(Re, K[x]), w), and Im likewise.
readReceptance := proc(file::string)
  local rows, last, omega, K, i, j, x;
  rows := ImportMatrix(file, source = csv, datatype = string);
  last := upperbound(rows)[1];
  omega := [seq(parse(rows[j, 1]), j = 2 .. last)];
  K := table():
  for i from 2 by 2 to upperbound(rows)[2] do
    x := parse(StringTools:-Substitute(StringTools:-Substitute(rows[1, i], "re_K(", ""), ")", ""));
    K[x] := [seq(parse(rows[j, i]) + I * parse(rows[j, i + 1]), j = 2 .. last)];
  end do;
  omega, eval(K);
end proc:
