#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fairlight/stats/domains.h>
#include <fairlight/stats/expectation.h>
#include <fairlight/stats/gauss_legendre.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/bsdf_checks.h>

namespace fairlight {
namespace {

constexpr int cuts = 6;
constexpr std::size_t cells = cuts * cuts;

// The integrals over a part of the sphere of the pdf and of f |cos| per channel.
using Parts = Eigen::Array4d;
using Integrand = std::function<Parts(double s, double t)>;

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

struct Quadrature {
  Parts value = Parts::Zero();
  double error = 0;  // of the pdf's integral and of the channels' together
};

// Halves a rectangle both ways until two rules differ by less than `tolerance`, at most `depth` times.
void integrate(const Integrand& f, const Rectangle& r, const Parts& coarse, double tolerance, int depth,
               Quadrature& total) {
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

// A BSDF seen from one direction: its draws, and 36 cells of the sphere with about equally many.
class View {
 public:
  View(const BsdfUnderTest& bsdf, const Vec3<double>& out, Generator generator)
      : bsdf_(bsdf), out_(out), generator_(generator), u_(bsdf.dimensions) {
    place_cells();
    const Integrand parts = [this](double s, double t) {
      const Vec3<double> in = sphere_.at(s, t);
      const Rgb<double> f = bsdf_.eval(out_, in) * std::abs(in.z());
      return Parts(Parts(bsdf_.pdf(out_, in), f[0], f[1], f[2]) * sphere_.size());
    };
    for (std::size_t i = 0; i < cells; ++i) {
      const std::size_t row = i / cuts, column = i % cuts;
      // A cell across the horizon would have a jump in it.
      for (const auto& [low, high] : std::array<std::pair<double, double>, 2>{{{0, 0.5}, {0.5, 1}}}) {
        const Rectangle r{std::max(s_[row], low), std::min(s_[row + 1], high), t_[row][column],
                          t_[row][column + 1]};
        if (r.s0 < r.s1 && r.t0 < r.t1) integrate(parts, r, gauss(parts, r), 1e-5, 6, cells_[i]);
      }
      all_.value += cells_[i].value;
      all_.error += cells_[i].error;
    }
  }

  const Quadrature& all() const { return all_; }

  std::optional<BsdfSample> draw() {
    for (double& x : u_) x = static_cast<double>(generator_() >> 11) * 0x1p-53;
    return bsdf_.sample(out_, u_);
  }

  // The cell of a draw; `cells` for one without a density.
  std::size_t cell_of(const std::optional<BsdfSample>& sample) const {
    if (!sample || sample->pdf == 0) return cells;
    const Eigen::Vector2d place = sphere_.coordinates(sample->in);
    const std::size_t row = index(s_, place.x());
    return row * cuts + index(t_[row], place.y());
  }

  // The draws' shares in the cells, relative to an equal share.
  std::vector<Reference> references() const {
    std::vector<Reference> those;
    for (std::size_t i = 0; i <= cells; ++i) {
      const Quadrature& part = i < cells ? cells_[i] : all_;
      const double mean = i < cells ? part.value[0] : std::max(0.0, 1 - part.value[0]);
      those.push_back({.mean = mean, .lower = 0, .upper = 1, .scale = 1.0 / cells, .rounding = part.error * cells});
    }
    return those;
  }

  std::string where(std::size_t cell) const {
    if (cell == cells) return "draws without a density";
    const std::size_t row = cell / cuts, column = cell % cuts;
    const auto degrees = [](double turns) { return 360 * turns; };
    const auto height = [&](double s) { return sphere_.at(s, 0).z(); };
    return formatted("directions with z from %.4f to %.4f and azimuths from %.1f to %.1f degrees",
                     height(s_[row + 1]), height(s_[row]), degrees(t_[row][column]), degrees(t_[row][column + 1]));
  }

 private:
  static std::size_t index(const std::array<double, cuts + 1>& ends, double x) {
    const auto after = std::upper_bound(ends.begin() + 1, ends.end() - 1, x);
    return static_cast<std::size_t>(after - ends.begin()) - 1;
  }

  // Ends at the sixths of the values.
  static std::array<double, cuts + 1> sixths(std::vector<double> values) {
    std::array<double, cuts + 1> ends{};
    ends.back() = 1;
    std::sort(values.begin(), values.end());
    for (std::size_t i = 1; i < cuts; ++i) {
      const double equal = static_cast<double>(i) / cuts;
      ends[i] = values.empty() ? equal : values[i * values.size() / cuts];
    }
    return ends;
  }

  // Rows at the sixths of the heights of a pilot, then columns at the sixths of the azimuths in each.
  void place_cells() {
    std::vector<Eigen::Vector2d> places;
    for (int i = 0; i < 3600; ++i) {
      const std::optional<BsdfSample> sample = draw();
      if (sample && sample->pdf > 0) places.push_back(sphere_.coordinates(sample->in));
    }
    std::vector<double> heights;
    for (const Eigen::Vector2d& place : places) heights.push_back(place.x());
    s_ = sixths(heights);
    for (std::size_t row = 0; row < cuts; ++row) {
      std::vector<double> azimuths;
      for (const Eigen::Vector2d& place : places) {
        if (index(s_, place.x()) == row) azimuths.push_back(place.y());
      }
      t_[row] = sixths(azimuths);
    }
  }

  const BsdfUnderTest& bsdf_;
  Vec3<double> out_;
  Generator generator_;
  std::vector<double> u_;
  SphereDomain sphere_{1};
  std::array<double, cuts + 1> s_{};
  std::array<std::array<double, cuts + 1>, cuts> t_{};
  std::array<Quadrature, cells> cells_{};
  Quadrature all_;
};

Finding without_draws(const Trial& trial, Verdict verdict, double bias, const std::string& note) {
  Finding finding{.verdict = verdict, .guarantee = Guarantee::deterministic, .margin = trial.margin, .bias = bias};
  finding.interval = {bias, bias};
  finding.note = note;
  return with_token(trial, finding);
}

Finding law(const Trial& trial, View& view) {
  const double mass = view.all().value[0], error = view.all().error;
  if (error * cells > trial.margin / 4)
    return without_draws(trial, Verdict::undecided, 0,
                         formatted("the pdf cannot be integrated, its error is %.1e (it jumps too much)", error));
  if (mass > 1 + error)
    return without_draws(trial, Verdict::biased, mass - 1, formatted("the pdf integrates to %.6f", mass));
  const std::vector<Finding> each =
      test_each_mean(trial, view.references(), [&](std::uint64_t, std::vector<std::vector<double>>& channels) {
        for (std::size_t i = 0; i < channels[0].size(); ++i) {
          const std::size_t cell = view.cell_of(view.draw());
          for (std::size_t c = 0; c < channels.size(); ++c) channels[c][i] = c == cell ? 1 : 0;
        }
      });
  // The cell of the largest bias among those that failed.
  std::size_t shown = 0;
  for (std::size_t c = 1; c < each.size(); ++c) {
    const bool worse_verdict = worse(each[c].verdict, each[shown].verdict) != each[shown].verdict;
    if (worse_verdict ||
        (each[c].verdict == each[shown].verdict && std::abs(each[c].bias) > std::abs(each[shown].bias)))
      shown = c;
  }
  Finding finding = each[shown];
  if (finding.verdict != Verdict::biased || finding.draws == 0) return finding;
  const double expected = view.references()[shown].mean;
  finding.note = formatted("%s have a share of %.4f of the draws, the pdf gives them %.4f",
                           view.where(shown).c_str(), std::max(0.0, expected + finding.bias / cells), expected);
  return finding;
}

Finding energy(const Trial& trial, const View& view) {
  const Parts& parts = view.all().value;
  const double most = parts.tail<3>().maxCoeff();
  const std::string note = formatted("f |cos| integrates to %.6f, %.6f and %.6f", parts[1], parts[2], parts[3]);
  const bool within = most <= 1 + view.all().error + 1e-6;  // of the code's own rounding
  return without_draws(trial, within ? Verdict::certified : Verdict::biased, most - 1, note);
}

Finding albedo(const Trial& trial, View& view, const BsdfTerms& terms, const Vec3<double>& out) {
  const Rgb<double> expected = terms.albedo(out);
  std::vector<Reference> references;
  for (const double mean : expected)
    references.push_back({.mean = mean, .lower = 0, .upper = terms.largest_weight, .scale = 1});
  return test_means(trial, references, [&](std::uint64_t, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      const std::optional<BsdfSample> sample = view.draw();
      for (std::size_t c = 0; c < 3; ++c)
        channels[c][i] = sample ? sample->weight[static_cast<Eigen::Index>(c)] : 0;
    }
  });
}

std::string seen_from(const Vec3<double>& out) {
  return formatted(" (out = (%.4f, %.4f, %.4f))", out.x(), out.y(), out.z());
}

}  // namespace

std::vector<Vec3<double>> directions_of_laws(const BsdfTerms& terms, const std::function<double()>& next) {
  std::vector<Vec3<double>> directions;
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && !terms.both_sides) break;
    for (const auto& [low, high] : std::array<std::pair<double, double>, 3>{{{0.02, 0.2}, {0.2, 0.7}, {0.7, 1}}})
      directions.push_back(drawn_direction(low, high, side, next));
  }
  return directions;
}

std::vector<BsdfFinding> check_bsdf_laws(const Trial& trial, const BsdfUnderTest& bsdf, const BsdfTerms& terms) {
  Generator generator = generator_for(trial, "directions");
  const auto directions =
      directions_of_laws(terms, [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; });
  Trial each = trial;
  each.alpha = trial.alpha / (2 * static_cast<double>(directions.size()));
  std::vector<BsdfFinding> findings;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    View view(bsdf, directions[i], generator_for(trial, "law " + std::to_string(i)));
    const std::string from = seen_from(directions[i]);
    findings.push_back({"law", "samples follow the pdf" + from, law(each, view)});
    if (terms.passive)
      findings.push_back({"energy", "f reflects no more light than it gets" + from, energy(each, view)});
    if (terms.albedo)
      findings.push_back(
          {"albedo", "the mean weight is the stated albedo" + from, albedo(each, view, terms, directions[i])});
  }
  return findings;
}

std::vector<BsdfFinding> check_bsdf(const Trial& trial, const BsdfUnderTest& bsdf, const BsdfTerms& terms) {
  check_trial(trial);
  if (bsdf.dimensions < 1 || bsdf.dimensions > 6)
    throw std::invalid_argument("a BSDF takes 1 to 6 numbers (set `dimensions` of the adapter)");
  if (!(terms.rounding > 0 && terms.rounding < 1))
    throw std::invalid_argument("the rounding of a BSDF must be in (0,1) (it is relative)");
  if (terms.albedo && !(terms.largest_weight > 0))
    throw std::invalid_argument("a stated albedo needs `largest_weight`, a bound on the weights");
  std::vector<BsdfFinding> findings = check_bsdf_identities(trial, bsdf, terms);
  const auto broken = [](const BsdfFinding& f) { return f.finding.verdict != Verdict::certified; };
  if (std::any_of(findings.begin(), findings.end(), broken)) return findings;
  for (BsdfFinding& more : check_bsdf_laws(trial, bsdf, terms)) findings.push_back(std::move(more));
  return findings;
}

}  // namespace fairlight
