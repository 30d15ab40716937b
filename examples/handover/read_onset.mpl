# Reads onset.json, which `mpsolve onset CASE.toml --json > onset.json` wrote, into Maple: [alpha, q] with every proved digit,
# the first unstable velocity ratio and the root +-q that turns unstable there; [] where no onset was found in the range.
readOnset := proc(file::string)
  local answer;
  answer := JSON:-ParseFile(file)["answer"];
  if answer["kind"] = "crosses" then
    [parse(answer["value"]["decimal"]), parse(answer["q"]["decimal"])];
  else
    [];
  end if;
end proc:
