#include <cmath>
#include <numbers>

#include <fairlight/estimators/stream.h>
#include <fairlight/stats/chi_square.h>
#include <fairlight/stats/kolmogorov_smirnov.h>
#include <fairlight/stats/law_test.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/rosenblatt.h>
#include <fairlight/stats/second_order.h>
#include <fairlight/stats/sequential_t_test.h>
#include <fairlight/validation/audit/joint_kinds.h>
#include <fairlight/validation/audit/test_kinds.h>
#include <fairlight/validation/checks/means.h>

namespace fairlight {
namespace {

// The uniform random numbers of a trial: number `i` of stream `unit`.
class Numbers {
 public:
  explicit Numbers(const Trial& trial) : key_(trial.seed, trial.claim) {}
  double operator()(std::uint64_t i, std::uint32_t unit = 0) const {
    return PhiloxStream<double>(key_, unit, i).next();
  }

 private:
  StreamKey key_;
};

double exponential(double u) { return -std::log1p(-u); }

// Draws that fill every channel from draw(i, channel).
template <class Draw>
DrawBlock block_of(const Draw& draw) {
  return [draw](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t c = 0; c < channels.size(); ++c) {
      for (std::size_t i = 0; i < channels[c].size(); ++i)
        channels[c][i] = draw(first + i, static_cast<std::uint32_t>(c));
    }
  };
}

Finding one_sided(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t) { return 2 * u(i) * (1 + bias); };
  return test_means(trial, {{1, 0, 2.5, 0, 1, Sides::not_above}}, block_of(draw));
}

Finding channels(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t c) { return 2 * u(i, c) * (c == 1 ? 1 + bias : 1); };
  return test_means(trial, {{1, 0, 2}, {1, 0, 2.5}, {1, 0, 2}}, block_of(draw));
}

Finding difference(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t) { return 2 * u(i) * (1 + bias) - 2 * u(i, 1); };
  return test_means(trial, {{0, -2, 2.5, 0, 1}}, block_of(draw));
}

// A mean in double with a packet control variate. The share of the bias in the packets equals their
// share of the margin.
template <std::uint32_t points, std::size_t share>
Finding control_variate(const Trial& trial, double bias) {
  const PacketControlVariate::Plan plan{{points}, PacketControlVariate::Plan::shares[share]};
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const double part = lanes<Real> > 1 ? plan.share : 1;
    return Real(rounded<Real>(2 * (1 + part * bias)) * source.next());
  };
  const PairedDraws draws = paired_draws<Packet>(body_of<double>(draw), body_of<Packet>(draw), 1);
  return PacketControlVariate(trial, {{1, 0, 2.5}}, draws).finding(plan);
}

Finding student(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t) { return exponential(u(i)) * (1 + bias); };
  return sequential_t_test(trial, 1, 1, block_of(draw));
}

Finding welch(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t c) {
    return c == 0 ? exponential(u(i)) * (1 + bias) : 0.5 + u(i, 1);
  };
  return sequential_welch_test(trial, 1, block_of(draw));
}

Finding counts(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double half = (1 + bias) / 2;  // the share of the lower eight of the sixteen cells
  return test_law(
      trial, DiscreteDomain{16}, [](std::int64_t) { return 1.0 / 16; },
      [&](std::uint64_t i) {
        const double x = u(i);
        const double place = x < half ? x / half / 2 : 0.5 + (x - half) / (1 - half) / 2;
        return static_cast<std::int64_t>(16 * place);
      });
}

Finding two_cells(const Trial& trial, double bias) {
  const Numbers u(trial);
  return test_law(
      trial, DiscreteDomain{2}, [](std::int64_t) { return 0.5; },
      [&](std::uint64_t i) { return std::int64_t{u(i) < (1 + bias) / 2}; });
}

// Draws of the density 1 + b (2s - 1), by inversion, tested against the uniform density. Their L2
// distance is b / sqrt3.
Finding density(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double b = bias * std::numbers::sqrt3;
  return test_law(
      trial, IntervalDomain{0, 1}, [](double) { return 1.0; },
      [&](std::uint64_t i) {
        const double c = 1 - b;
        return 2 * u(i) / (c + std::sqrt(c * c + 4 * b * u(i)));
      });
}

// The fault is a negative bias: the sign is reversed.
Finding not_below(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t) { return 2 * u(i) * (1 - bias); };
  return test_means(trial, {{1, 0, 2.5, 0, 1, Sides::not_below}}, block_of(draw));
}

// A single sample of fixed size, large enough to detect u^(1/(1+margin)) at a level of 1e-8.
Finding kolmogorov(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double farthest = trial.margin / std::numbers::e;
  const double reach = std::sqrt(std::log(4 / trial.alpha) / 2) + 2.5;
  std::vector<double> sample(static_cast<std::size_t>(std::pow(reach / farthest, 2)) * 2);
  for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = std::pow(u(i), 1 / (1 + bias));
  const KolmogorovSmirnov result = kolmogorov_smirnov(sample);
  const bool alarm = result.too_far < trial.alpha / 2 || result.too_near < trial.alpha / 2;
  return Finding{alarm ? Verdict::biased : Verdict::certified, Guarantee::asymptotic, trial.margin};
}

// Draws of the density 2 s (1 + a sqrt2 cos(pi t)), by inversion. The claim is a = 0.
Finding moments_of_the_law(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double a = bias * std::numbers::sqrt2;
  const auto wave = [a](double v) {
    double t = v;
    for (int k = 0; k < 30; ++k) t = v - a * std::sin(std::numbers::pi * t) / std::numbers::pi;
    return t;
  };
  return test_rosenblatt(
      trial, [](double s, double) { return 2 * s; },
      [&](std::uint64_t i) { return Eigen::Vector2d(std::sqrt(u(i)), wave(u(i, 1))); });
}

Finding variance(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double stretch = std::sqrt(1 + bias);
  return test_variance(trial, 1.0 / 12, {[=](std::uint64_t i) { return stretch * u(i); }, 0, 1.1});
}

Finding variance_at_most(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double stretch = std::sqrt(0.5 * (1 + bias));
  return test_variance_ratio(trial, 0.5, {[=](std::uint64_t i) { return stretch * u(i); }, 0, 1.1},
                             {[=](std::uint64_t i) { return u(i, 1); }, 0, 1});
}

// With probability |bias| the second number is the first, or its mirror image.
Finding correlation(const Trial& trial, double bias) {
  const Numbers u(trial);
  return test_uncorrelated(trial, {0.5, 0.5}, 0.5, 1.0 / 12, [=](std::uint64_t i) {
    const double a = u(i);
    if (u(i, 2) >= std::abs(bias)) return std::pair(a, u(i, 1));
    return std::pair(a, bias > 0 ? a : 1 - a);
  });
}

// A replicate is the mean of 2x over four stratified points.
Finding replicates(const Trial& trial, double bias) {
  const Numbers u(trial);
  return test_means(trial, {{1, 0, 2.5}}, one_channel([=](std::uint64_t r) {
                      double sum = 0;
                      for (std::uint32_t k = 0; k < 4; ++k) sum += 2 * (k + u(r, k)) / 4;
                      return sum / 4 * (1 + bias);
                    }));
}

std::vector<TestKind> build() {
  std::vector<TestKind> kinds;
  for (const CostLaw& law : cost_laws()) {
    kinds.push_back({"betting." + law.name, false,
                     [law](const Trial& trial, double bias) { return bet_on(law, trial, bias); }});
  }
  constexpr std::size_t last_share = PacketControlVariate::Plan::shares.size() - 1;
  const std::vector<TestKind> others{
      {"betting.one_sided", true, one_sided},
      {"betting.not_below", true, not_below},
      {"betting.channels", false, channels},
      {"betting.difference", false, difference},
      {"betting.packet_control_variate", false, control_variate<1, 0>},
      {"betting.packet_control_variate.points", false, control_variate<points_a_replicate, last_share>},
      {"t.exponential", false, student},
      {"welch.unlike_variances", false, welch},
      {"counts", false, counts},
      {"counts.coin", false, two_cells},
      {"law.interval", false, density},
      {"kolmogorov_smirnov", false, kolmogorov},
      {"rosenblatt", false, moments_of_the_law},
      {"variance", false, variance},
      {"variance_ratio", true, variance_at_most},
      {"uncorrelated", false, correlation},
      {"replicates", false, replicates}};
  kinds.insert(kinds.end(), others.begin(), others.end());
  kinds.insert(kinds.end(), joint_kinds().begin(), joint_kinds().end());
  return kinds;
}

CostLaw bernoulli(const std::string& name, double p, double margin, double limit) {
  return {name, (1 - p) / p, margin, 1.2 / p, 0, limit, [p](double u) { return u < p ? 1 / p : 0.0; }};
}

// A draw of 0 with probability p, else of 1 / (1 - p).
CostLaw rare_loss(double p, double margin, double limit) {
  return {
      "rare_loss", p / (1 - p), margin, 1.2 / (1 - p), 0, limit, [p](double u) { return u < p ? 0 : 1 / (1 - p); }};
}

}  // namespace

const std::vector<TestKind>& test_kinds() {
  static const std::vector<TestKind> kinds = build();
  return kinds;
}

// Pareto's law of index 5/2 with lower bound 3/5 has E[(X - B)+] = (3/5)^(5/2) B^(-3/2) / (3/2),
// which is 2.2e-5 at B = 450.
const std::vector<CostLaw>& cost_laws() {
  static const std::vector<CostLaw> laws{
      bernoulli("bernoulli_0.5", 0.5, 0.01, 18),
      bernoulli("bernoulli_0.01", 0.01, 0.02, 20),
      rare_loss(0.09, 0.1, 25),
      {"exponential", 1, 0.01, 25, 1e-9, 18, exponential},
      {"pareto_2.5", 0.8, 0.01, 450, 3e-5, 0, [](double u) { return 0.6 * std::pow(1 - u, -0.4); }},
  };
  return laws;
}

Finding bet_on(const CostLaw& law, const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [&](std::uint64_t i, std::uint32_t) { return law.draw(u(i)) * (1 + bias); };
  return test_means(trial, {{1, 0, law.upper, law.tail_slack}}, block_of(draw));
}

}  // namespace fairlight
