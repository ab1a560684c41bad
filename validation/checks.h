#pragma once

#include <functional>
#include <vector>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/stream.h>
#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/chi_square.h>
#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/claim.h>

namespace fairlight {

/// What is claimed of one channel of an estimator. All in the estimator's unit.
struct Reference {
  double mean;
  double lower;  ///< no draw is below
  double upper;  ///< no draw is above; or, with a tail slack, E[(X - upper)+] <= tail_slack
  double tail_slack = 0;
  double scale =
      mean;  ///< what margin and bias are relative to; for a difference, where the mean is 0, its terms' mean
};

/// Fills channels[c][i] with channel c of draw first + i, for every i.
using DrawBlock = std::function<void(std::uint64_t first, std::vector<std::vector<double>>& channels)>;

/// The core test on every channel of an estimator, each with its part of alpha. Certified when all channels are,
/// biased when one is; a draw that the reference rules out is `biased` too, named in the note. Guarantee: exact.
Finding check_means(const Trial& trial, const std::vector<Reference>& references, const DrawBlock& draw_block);

/// Cells of a domain against counted draws: the density integrates to one, no draw has density zero, and chi-square
/// with the number of draws that the margin (a relative L2 distance) asks for. Guarantee: asymptotic.
struct LawCells {
  int rows = 16;
  int columns = 8;
  std::vector<double> probabilities;
  double total_error;  ///< of the quadrature
};
Finding check_counts(const Trial& trial, const LawCells& cells,
                     const std::function<std::vector<std::uint64_t>(std::uint64_t draws)>& count);

/// The mean of an estimator, one reference per channel: `draw(source)` gives a double or an Rgb<double>.
template <class Draw>
Finding check_mean(const Trial& trial, const std::vector<Reference>& references, const Draw& draw) {
  const StreamKey key(trial.seed, trial.claim);
  return check_means(trial, references, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      PhiloxStream<double> source(key, 0, first + i);
      const auto x = draw(source);
      if constexpr (std::is_convertible_v<decltype(x), double>) {
        channels[0][i] = x;
      } else {
        for (std::size_t c = 0; c < channels.size(); ++c) channels[c][i] = x[static_cast<Eigen::Index>(c)];
      }
    }
  });
}

/// Every draw equals the reference to within `ulps` units in the last place: an estimator without variance.
template <class Draw>
Finding check_constant(const Trial& trial, double reference, int ulps, const Draw& draw) {
  constexpr std::uint64_t draws = 100'000;
  const double tolerance = ulps * std::numeric_limits<double>::epsilon();
  const StreamKey key(trial.seed, trial.claim);
  Finding finding{.verdict = Verdict::certified, .guarantee = Guarantee::deterministic, .margin = tolerance};
  for (finding.draws = 0; finding.draws < draws; ++finding.draws) {
    PhiloxStream<double> source(key, 0, finding.draws);
    const double error = draw(source) / reference - 1;
    if (!(std::abs(error) <= std::abs(finding.bias))) finding.bias = error;
    finding.interval = {std::min(finding.interval.lo, error), std::max(finding.interval.hi, error)};
    if (std::abs(error) <= tolerance) continue;
    finding.verdict = Verdict::biased;
    finding.note =
        "draw " + std::to_string(finding.draws) + " is off by " + std::to_string(error / tolerance * ulps) + " ulp";
    return finding;
  }
  return finding;
}

/// A sampler's draws follow its density, and the density integrates to one over the domain.
template <Sampler Law, class Domain>
Finding check_law(const Trial& trial, const Law& law, const Domain& domain) {
  LawCells cells;
  cells.total_error = 0;
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column) {
      const Integral cell =
          integrate_rectangle([&](double s, double t) { return law.pdf(domain.at(s, t)).value() * domain.size(); },
                              double(row) / cells.rows, double(row + 1) / cells.rows,
                              double(column) / cells.columns, double(column + 1) / cells.columns);
      cells.probabilities.push_back(cell.value);
      cells.total_error += cell.error;
    }
  }
  const StreamKey key(trial.seed, trial.claim);
  return check_counts(trial, cells, [&](std::uint64_t draws) {
    std::vector<std::uint64_t> counts(cells.probabilities.size());
    for (std::uint64_t i = 0; i < draws; ++i) {
      PhiloxStream<double> source(key, 0, i);
      const auto x = law.sample(next_pair<double>(source));
      const double density = law.pdf(x).value();
      if (!(density > 0 && std::isfinite(density))) throw BadDraw(i, density, "the density where a draw was made");
      const Vec2<double> place = domain.coordinates(x);
      if (!(place.minCoeff() >= 0 && place.maxCoeff() <= 1)) throw BadDraw(i, place.x(), "outside the domain");
      const int row = std::min(static_cast<int>(place.x() * cells.rows), cells.rows - 1);
      const int column = std::min(static_cast<int>(place.y() * cells.columns), cells.columns - 1);
      ++counts[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns) +
               static_cast<std::size_t>(column)];
    }
    return counts;
  });
}

}  // namespace fairlight
