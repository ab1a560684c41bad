#include <algorithm>

#include <fairlight/validation/checks/estimand.h>

namespace fairlight {
namespace {

// The floor of a claim's margin, however fine the run's margin is; 0 means no floor. It applies
// where the references themselves carry rounding, such as the positions in a scene far from the
// origin. Where only the rounding of floats is too coarse for a margin, there is no floor, and the
// test refuses the margin.
double finest_margin_of(const std::vector<Reference>& references, double rounding) {
  return finest_margin(references) > 0 ? finest_margin(rounded_references(references, rounding)) : 0;
}

bool adds_up(const std::vector<Reference>& references) {
  return !references.empty() &&
         std::ranges::all_of(references, [](const Reference& r) { return r.mean > 0 && r.sides == Sides::both; });
}

// The row in the arithmetic of these draws.
Claim mean_row(const MeanStatement& e, const Draws& draws, std::function<Finding(const Trial&)> check) {
  return {.name = e.name + suffix_of(draws),
          .kind = "mean",
          .subjects = e.subjects,
          .statement = e.statement,
          .source = e.source,
          .margin_factor = e.margin_factor,
          .check = std::move(check),
          .real = real_of(draws),
          .finest_margin = finest_margin_of(e.references, draws.rounding),
          .adds_up = adds_up(e.references)};
}

}  // namespace

std::string suffix_of(const Draws& draws) { return draws.lanes > 1 ? ".packet" : ""; }
std::string real_of(const Draws& draws) { return draws.lanes > 1 ? "packet" : "double"; }

Claim mean_row_alone(const MeanStatement& e, Draws draws) {
  return mean_row(e, draws, [references = e.references, draws](const Trial& trial) {
    return check_mean(trial, references, draws);
  });
}

Claim mean_row_in_double(const MeanStatement& e, PairedDraws draws) {
  return mean_row(e, draws.in_double, [references = e.references, draws](const Trial& trial) {
    return check_mean_in_double(trial, references, draws);
  });
}

Claim mean_row_in_packets(const MeanStatement& e, Draws draws) {
  return mean_row(e, draws, [references = e.references, draws](const Trial& trial) {
    return check_mean_in_packets(trial, references, draws);
  });
}

Claim constant_row(const ConstantStatement& e, Draws draws) {
  const double ulp_of = draws.lanes > 1 ? double{ulp<Packet>} : ulp<double>;
  return {.name = e.name + suffix_of(draws),
          .kind = "constant",
          .subjects = e.subjects,
          .statement = e.statement + formatted(", to %d ulp", e.ulps),
          .source = e.source,
          .margin_factor = 1,
          .check = [value = e.value, tolerance = e.ulps * ulp_of,
                    draws](const Trial& trial) { return check_constant(trial, value, tolerance, draws); },
          .real = real_of(draws)};
}

Claim replicates_row(const MeanStatement& e, const std::string& suffix, const std::vector<std::string>& subjects,
                     double margin_factor, std::function<Finding(const Trial&)> check) {
  std::vector<std::string> all = e.subjects;
  all.insert(all.end(), subjects.begin(), subjects.end());
  return {.name = e.name + "." + suffix,
          .kind = "mean",
          .subjects = all,
          .statement = e.statement + ", over the points of a replicate",
          .source = e.source,
          .margin_factor = margin_factor * e.margin_factor,
          .check = std::move(check),
          .real = "packet",
          .adds_up = adds_up(e.references)};
}

}  // namespace fairlight
