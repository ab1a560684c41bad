#include <cmath>
#include <numbers>

#include <fairlight/stats/catoni_test.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/second_order.h>
#include <fairlight/stats/sequential_t_test.h>
#include <fairlight/validation/audit/audit_numbers.h>
#include <fairlight/validation/audit/joint_kinds.h>
#include <fairlight/validation/audit/law_kinds.h>
#include <fairlight/validation/audit/test_kinds.h>
#include <fairlight/validation/checks/means.h>

namespace fairlight {
namespace {

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

// A twentieth of the draws is 20, the others are 0.
Finding rare_coin(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t) { return u(i) < 0.05 * (1 + bias) ? 20.0 : 0.0; };
  return sequential_t_test(trial, 1, 1, block_of(draw));
}

// Pareto's law of index 5/2 and mean 1 has the variance 0.8, and no third moment.
Finding catoni(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t) { return 0.6 * std::pow(1 - u(i), -0.4) * (1 + bias); };
  return catoni_test(trial, {1, 1}, 1, block_of(draw));
}

Finding welch(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t c) {
    return c == 0 ? exponential(u(i)) * (1 + bias) : 0.5 + u(i, 1);
  };
  return sequential_welch_test(trial, 1, block_of(draw));
}

// The fault is a negative bias: the sign is reversed.
Finding not_below(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto draw = [=](std::uint64_t i, std::uint32_t) { return 2 * u(i) * (1 - bias); };
  return test_means(trial, {{1, 0, 2.5, 0, 1, Sides::not_below}}, block_of(draw));
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
      {"t.exponential", false, student, false},
      {"welch.unlike_variances", false, welch, false},
      {"t.coin", false, rare_coin, false},
      {"catoni.pareto", false, catoni},
      {"variance", false, variance},
      {"variance_ratio", true, variance_at_most},
      {"uncorrelated", false, correlation},
      {"replicates", false, replicates}};
  kinds.insert(kinds.end(), others.begin(), others.end());
  for (const auto& more : {law_kinds(), joint_kinds()}) kinds.insert(kinds.end(), more.begin(), more.end());
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
