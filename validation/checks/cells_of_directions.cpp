#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fairlight/stats/domains.h>
#include <fairlight/stats/gauss_legendre.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/direction_checks.h>

namespace fairlight {
namespace {

using Parts = CellsOfDirections::Parts;
using Integrand = std::function<Parts(double s, double t)>;

constexpr SphereDomain sphere{1};

struct Rectangle {
  double s0, s1, t0, t1;
};

Parts gauss(const Integrand& f, const Rectangle& r) {
  const GaussLegendre<16>& rule = gauss_legendre<16>();
  const auto sum = [&](double low, double high, const auto& g) {
    Parts total = Parts::Zero();
    for (std::size_t i = 0; i < rule.reach.size(); ++i) {
      for (const double x : {0.5 - rule.reach[i], 0.5 + rule.reach[i]})
        total += rule.weight[i] * (high - low) * g(low + (high - low) * x);
    }
    return total;
  };
  return sum(r.s0, r.s1,
             [&](double s) -> Parts { return sum(r.t0, r.t1, [&](double t) -> Parts { return f(s, t); }); });
}

// Halves a rectangle both ways until two rules differ by less than `tolerance`, at most `depth` times.
void integrate(const Integrand& f, const Rectangle& r, const Parts& coarse, double tolerance, int depth,
               CellsOfDirections::Quadrature& total) {
  const double s = (r.s0 + r.s1) / 2, t = (r.t0 + r.t1) / 2;
  const std::array<Rectangle, 4> quarters{
      {{r.s0, s, r.t0, t}, {s, r.s1, r.t0, t}, {r.s0, s, t, r.t1}, {s, r.s1, t, r.t1}}};
  std::array<Parts, 4> fine;
  std::transform(quarters.begin(), quarters.end(), fine.begin(), [&](const Rectangle& q) { return gauss(f, q); });
  const Parts sum = fine[0] + fine[1] + fine[2] + fine[3];
  const double error = (sum - coarse).abs().maxCoeff();
  if (error <= tolerance || depth == 0) {
    total.value += sum;
    total.error += error;
    return;
  }
  for (std::size_t i = 0; i < 4; ++i) integrate(f, quarters[i], fine[i], tolerance / 2, depth - 1, total);
}

}  // namespace

CellsOfDirections::CellsOfDirections(const DirectionsUnderTest& law, Generator generator,
                                     const std::function<Rgb<double>(const Vec3<double>&)>& beside)
    : law_(law) {
  place_cells(generator);
  const Integrand parts = [&](double s, double t) {
    const Vec3<double> direction = at(s, t);
    const Rgb<double> more = beside(direction);
    return Parts(Parts(law.pdf(direction), more[0], more[1], more[2]) * sphere.size());
  };
  for (std::size_t i = 0; i < cuts * cuts; ++i) {
    const std::size_t row = i / cuts, column = i % cuts;
    Quadrature cell;
    // A cell across the horizon would have a jump in it.
    for (const auto& [low, high] : std::array<std::pair<double, double>, 2>{{{0, 0.5}, {0.5, 1}}}) {
      const Rectangle r{std::max(heights_[row], low), std::min(heights_[row + 1], high), azimuths_[row][column],
                        azimuths_[row][column + 1]};
      if (r.s0 < r.s1 && r.t0 < r.t1) integrate(parts, r, gauss(parts, r), 1e-5, 6, cell);
    }
    for (Quadrature* sum : {&cells_[cell_at(row, column)], &all_}) {
      sum->value += cell.value;
      sum->error += cell.error;
    }
  }
}

Eigen::Vector2d CellsOfDirections::place_of(const Vec3<double>& direction) const {
  const Eigen::Vector2d place = sphere.coordinates(direction);
  const double t = place.y() + turn_;
  return {place.x(), t - std::floor(t)};
}

Vec3<double> CellsOfDirections::at(double s, double t) const {
  const double back = t - turn_;
  return sphere.at(s, back - std::floor(back));
}

// The least and the greatest value, the sixths between them, and a quarter of their distance beyond,
// where a sliver of the support may be that no value is in. Without values, equal parts.
CellsOfDirections::Ends CellsOfDirections::ends_for(std::vector<double> values) {
  Ends ends{};
  ends.back() = 1;
  if (values.empty()) {
    for (std::size_t i = 1; i < cuts; ++i) ends[i] = static_cast<double>(i) / cuts;
    return ends;
  }
  std::sort(values.begin(), values.end());
  for (std::size_t i = 0; i <= 6; ++i) ends[i + 2] = values[i * (values.size() - 1) / 6];
  const double beyond = (values.back() - values.front()) / 4;
  ends[1] = std::max(0.0, values.front() - beyond);
  ends[cuts - 1] = std::min(1.0, values.back() + beyond);
  return ends;
}

std::size_t CellsOfDirections::index(const Ends& ends, double x) {
  const auto after = std::upper_bound(ends.begin() + 1, ends.end() - 1, x);
  return static_cast<std::size_t>(after - ends.begin()) - 1;
}

// Rows by the heights of a pilot's draws, then columns by the azimuths in each.
void CellsOfDirections::place_cells(Generator& generator) {
  std::vector<Vec3<double>> drawn;
  std::vector<double> u(law_.dimensions);
  for (int i = 0; i < 3600; ++i) {
    for (double& x : u) x = uniform(generator);
    const std::optional<DirectionSample> sample = law_.sample(u);
    if (sample && sample->pdf > 0) drawn.push_back(sample->direction);
  }
  const Vec3<double> sum = std::accumulate(drawn.begin(), drawn.end(), zero<Vec3<double>>());
  if (sum.x() != 0 || sum.y() != 0) turn_ = 0.5 - sphere.coordinates(sum.normalized()).y();
  std::vector<Eigen::Vector2d> places;
  for (const Vec3<double>& direction : drawn) places.push_back(place_of(direction));
  std::vector<double> heights;
  for (const Eigen::Vector2d& place : places) heights.push_back(place.x());
  heights_ = ends_for(heights);
  for (std::size_t row = 0; row < cuts; ++row) {
    const bool rim = row < 2 || row + 2 >= cuts;
    std::vector<double> azimuths;
    for (const Eigen::Vector2d& place : places) {
      if (rim || index(heights_, place.x()) == row) azimuths.push_back(place.y());
    }
    azimuths_[row] = ends_for(azimuths);
  }
}

// Row by row; `inner` for the rim.
std::size_t CellsOfDirections::cell_at(std::size_t row, std::size_t column) {
  const auto in_rim = [](std::size_t i) { return i < 2 || i + 2 >= cuts; };
  return in_rim(row) || in_rim(column) ? inner : (row - 2) * 6 + column - 2;
}

// The cell of a draw; `lost` for one without a density.
std::size_t CellsOfDirections::cell_of(const std::optional<DirectionSample>& sample) const {
  if (!sample || sample->pdf == 0) return lost;
  const Eigen::Vector2d place = place_of(sample->direction);
  const std::size_t row = index(heights_, place.x());
  return cell_at(row, index(azimuths_[row], place.y()));
}

std::vector<Reference> CellsOfDirections::references(bool whole) const {
  std::vector<Reference> those;
  const auto add = [&](double mean, double error) {
    those.push_back({.mean = mean, .lower = 0, .upper = 1, .scale = equal_share, .rounding = error / equal_share});
  };
  for (const Quadrature& cell : cells_) add(cell.value[0], cell.error);
  if (!whole) add(std::max(0.0, 1 - all_.value[0]), all_.error);
  return those;
}

std::string CellsOfDirections::where(std::size_t cell) const {
  if (cell == lost) return "draws without a density";
  if (cell == inner) return "directions at the rim of the draws or beyond";
  const std::size_t row = 2 + cell / 6, column = 2 + cell % 6;
  const auto height = [&](double s) { return sphere.at(s, 0).z(); };
  return formatted("directions with z from %.4f to %.4f and azimuths from %.1f to %.1f degrees",
                   height(heights_[row + 1]), height(heights_[row]), 360 * (azimuths_[row][column] - turn_),
                   360 * (azimuths_[row][column + 1] - turn_));
}

// What the integrals alone say: nothing, if a test by draws can be made.
std::optional<Finding> CellsOfDirections::without_draws(const Trial& trial, const DirectionTerms& terms) const {
  const double mass = all_.value[0];
  const double slack = all_.error + terms.rounding;
  double error = terms.whole ? 0 : all_.error;
  for (const Quadrature& cell : cells_) error = std::max(error, cell.error);
  Finding finding{.verdict = Verdict::biased, .guarantee = Guarantee::deterministic, .margin = trial.margin};
  finding.bias = mass - 1;
  finding.interval = {finding.bias, finding.bias};
  if (!std::isfinite(mass)) {
    finding.note = "the pdf is not finite somewhere";
  } else if (mass > 1 + slack || (terms.whole && mass < 1 - slack)) {
    finding.note = formatted("the pdf integrates to %.6f", mass);
  } else if (error > trial.margin * equal_share / 4) {
    finding.verdict = Verdict::undecided;
    finding.note = formatted("the pdf cannot be integrated, an error is %.1e (it jumps too much)", error);
  } else {
    return {};
  }
  return with_token(trial, finding);
}

Finding CellsOfDirections::test(const Trial& trial, const DirectionTerms& terms, Generator generator) const {
  if (const std::optional<Finding> at_once = without_draws(trial, terms)) return *at_once;
  std::vector<double> u(law_.dimensions);
  const std::vector<Reference> shares = references(terms.whole);
  const std::vector<Finding> each =
      test_each_mean(trial, shares, [&](std::uint64_t, std::vector<std::vector<double>>& channels) {
        for (std::vector<double>& channel : channels) std::fill(channel.begin(), channel.end(), 0.0);
        for (std::size_t i = 0; i < channels[0].size(); ++i) {
          for (double& x : u) x = uniform(generator);
          const std::size_t cell = cell_of(law_.sample(u));
          if (cell < channels.size()) channels[cell][i] = 1;
        }
      });
  // The cell of the largest bias among those of the worst verdict.
  std::size_t shown = 0;
  for (std::size_t c = 1; c < each.size(); ++c) {
    const Verdict worst = worse(each[c].verdict, each[shown].verdict);
    if (worst != each[shown].verdict ||
        (worst == each[c].verdict && std::abs(each[c].bias) > std::abs(each[shown].bias)))
      shown = c;
  }
  Finding finding = each[shown];
  if (finding.verdict != Verdict::biased) return finding;
  const double drawn = std::max(0.0, shares[shown].mean + finding.bias * equal_share);
  finding.note = formatted("%s have a share of %.4f of the draws, the pdf gives them %.4f", where(shown).c_str(),
                           drawn, shares[shown].mean);
  return finding;
}

}  // namespace fairlight
