"""Steps of proofs that know no track and no vehicle: covering, counting, enclosing, effort."""
