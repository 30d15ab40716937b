# Reads seeds.csv of mpsolve into Maple: a list of [alpha, eta_b, eta_m, d, q, radius] with exact parameters.
# From any start within `radius` of q, Newton's method on Delta converges to the one root there, for any Digits:
#   seeds := readSeeds("seeds.csv"):  fsolve(Delta(z) = 0, z = seeds[1][5], complex);
readSeeds := proc(file::string)
  local rows, names, column, k;
  rows := ImportMatrix(file, source = csv, datatype = string);
  names := [seq(rows[1, k], k = 1 .. upperbound(rows)[2])];
  column := name -> ListTools:-Search(name, names);
  [seq([parse(rows[k, column("alpha")]), parse(rows[k, column("eta_b")]), parse(rows[k, column("eta_m")]),
        parse(rows[k, column("d")]), parse(rows[k, column("q_re")]) + I * parse(rows[k, column("q_im")]),
        parse(rows[k, column("radius")])], k = 2 .. upperbound(rows)[1])];
end proc:
