# Reads receptance.csv of mpsolve into Maple: a table with G[x][j], the receptance at xi = x and omega[j].
# A force exp(I*omega*t) that moves along deflects the rail at the distance xi ahead of it by G*exp(I*omega*t), in the
# units of the track. Between the frequencies, use CurveFitting:-Spline(omega, map(Re, G[x]), w), and Im likewise.
readReceptance := proc(file::string)
  local rows, last, omega, G, i, j, x;
  rows := ImportMatrix(file, source = csv, datatype = string);
  last := upperbound(rows)[1];
  omega := [seq(parse(rows[j, 1]), j = 2 .. last)];
  G := table():
  for i from 2 by 2 to upperbound(rows)[2] do
    x := parse(StringTools:-Split(StringTools:-Substitute(rows[1, i], "re_G(", ""), ")")[1]);
    G[x] := [seq(parse(rows[j, i]) + I * parse(rows[j, i + 1]), j = 2 .. last)];
  end do;
  omega, eval(G);
end proc:
