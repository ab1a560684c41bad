#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/identity.h>

namespace fairlight {

PartFinding finding_of(const Trial& trial, const Identity& identity, double rounding) {
  Finding finding;
  finding.verdict = identity.worst > rounding ? Verdict::biased : Verdict::certified;
  finding.guarantee = Guarantee::exact;
  finding.margin = rounding;
  finding.bias = identity.worst;
  finding.interval = {0, identity.worst};
  finding.draws = identity_draws;
  finding.note = finding.verdict == Verdict::biased ? identity.where
                                                    : formatted("shown for all but a share of %.1e of draws",
                                                                -std::log(trial.beta) / identity_draws);
  return {identity.check, identity.statement, with_token(trial, finding)};
}

void for_each_edge(std::size_t dimensions, const std::function<void(const std::vector<double>& u)>& f) {
  constexpr std::array<double, 5> numbers{0, 0x1p-53, 0.5, 1 - 0x1p-24, 1 - 0x1p-53};
  std::vector<double> u(dimensions);
  std::size_t combinations = 1;
  for (std::size_t d = 0; d < dimensions; ++d) combinations *= numbers.size();
  for (std::size_t k = 0; k < combinations; ++k) {
    std::size_t rest = k;
    for (double& x : u) {
      x = numbers[rest % numbers.size()];
      rest /= numbers.size();
    }
    f(u);
  }
}

double gap_between(double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return infinity<double>;
  return std::abs(x - y) / std::max({std::abs(x), std::abs(y), 1e-20});
}

double gap_between(const Rgb<double>& x, const Rgb<double>& y) {
  double gap = 0;
  for (int c = 0; c < 3; ++c) gap = std::max(gap, gap_between(x[c], y[c]));
  return gap;
}

bool is_valid(double x) { return std::isfinite(x) && x >= 0; }
bool is_valid(const Rgb<double>& colour) {
  return is_valid(colour[0]) && is_valid(colour[1]) && is_valid(colour[2]);
}

std::string problem_of(const Vec3<double>& direction, double pdf, double rounding) {
  if (!all_finite(direction)) return "its direction is " + text_of(direction);
  if (std::abs(direction.norm() - 1) > rounding) return "its direction is no unit vector: " + text_of(direction);
  if (!is_valid(pdf)) return formatted("its pdf is %g", pdf);
  return {};
}

std::string text_of(const Vec3<double>& v) { return formatted("(%.6g, %.6g, %.6g)", v.x(), v.y(), v.z()); }

std::string text_of(const Rgb<double>& c) { return formatted("(%.6g, %.6g, %.6g)", c[0], c[1], c[2]); }

std::string text_of(const std::vector<double>& numbers) {
  std::ostringstream list;
  list.precision(17);
  for (const double x : numbers) list << (&x == numbers.data() ? "" : " ") << x;
  return list.str();
}

}  // namespace fairlight
