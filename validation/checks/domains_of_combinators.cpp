#include <limits>

#include <fairlight/validation/checks/domains.h>

namespace fairlight {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

using Rows = std::vector<ParameterDomain>;

void append(Rows& rows, const Rows& more) { rows.insert(rows.end(), more.begin(), more.end()); }

// The rows of combinators of polynomials with drawn coefficients.
void add_polynomials(Rows& rows, const std::string& component) {
  append(rows, {{component, "coefficient", "1", -unlimited, unlimited,
                 "a factor of the integrand is one of its integral"},
                {component, "tilt of the law", "1", -1, 1, "by a steeper law, draws vary too much to be tested"}});
}

}  // namespace

std::vector<ParameterDomain> domains_of_combinators() {
  Rows rows;
  for (const char* each :
       {"ControlVariate", "MultiSampleMis", "OneSampleMis", "Rouletted", "Splitting", "StratifiedMean"})
    add_polynomials(rows, each);
  append(rows,
         {{"ControlVariate", "c", "1", -unlimited, unlimited, "with a larger factor the control alone is tested"},
          {"Rouletted", "q", "1", 0, 1, "the work for a given error grows as 1/q"},
          {"Splitting", "k", "1", 0, 1e9, "the work grows as k and as 1/k"},
          {"StratifiedMean", "columns", "1", 1, unlimited, "the work grows as the number of cells"},
          {"StratifiedMean", "rows", "1", 1, unlimited, "the work grows as the number of cells"}});
  for (const char* each : {"MultiSampleMis", "OneSampleMis"})
    rows.push_back({each, "width of a law", "1", 0, 1, "a law on nearly no part of the square is one on none"});
  rows.push_back({"OneSampleMis", "probability of a law", "1", 0, 1,
                  "a law that is rarer is never met; the others have larger ones"});
  for (const char* each : {"RouletteByReflectance", "RouletteByThroughput", "RouletteFromBounce"}) {
    append(rows, {{each, "albedo", "1", 0, 1, ""},
                  {each, "throughput", "1", 0, unlimited,
                   "the work grows as 1 / throughput; a larger one survives as 4 does"},
                  {each, "depth", "1", 0, unlimited, "all later bounces are alike"}});
  }
  for (const char* each : {"ContributionChoice", "PowerChoice", "UniformChoice"}) {
    append(rows, {{each, "phase of the weights", "1", 0, 1, ""}, {each, "phase of the signs", "1", 0, 1, ""}});
  }
  for (const char* each : {"ContributionChoice", "PowerChoice"})
    rows.push_back({each, "size of the terms", "1", 0, 1, ""});
  return rows;
}

}  // namespace fairlight
