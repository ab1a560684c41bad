#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <fairlight/estimators/stream.h>
#include <fairlight/render/parallel.h>
#include <fairlight/stats/chi_square.h>
#include <fairlight/stats/moments.h>
#include <fairlight/stats/uniformity.h>
#include <fairlight/validation/audit/tester_audit.h>

namespace fairlight {
namespace {

constexpr double chance = 1e-8;  // the probability that right tests exceed one limit: 1e-6 for all rows together
constexpr double calibration_level = 1e-2;  // 10^4 times the budget of a run
constexpr double audit_margin = 0.1;

// Counts the wrong verdicts over runs of a kind of test.
struct Job {
  const TestKind* kind;
  std::string name;
  double bias;
  Trial trial;
  Verdict right;
  int runs;
  int limit;
};

std::vector<TesterOutcome> run_jobs(const std::vector<Job>& jobs, std::uint64_t seed, int threads,
                                    const Progress& progress) {
  std::vector<TesterOutcome> outcomes;
  std::vector<std::pair<std::size_t, int>> units;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    outcomes.push_back({jobs[j].name, jobs[j].runs, 0, jobs[j].limit});
    for (int r = 0; r < jobs[j].runs; ++r) units.emplace_back(j, r);
  }
  std::vector<char> failed(units.size());
  const auto one = [&](std::size_t unit) {
    const auto [j, r] = units[unit];
    Trial trial = jobs[j].trial;
    trial.seed = seed + static_cast<std::uint64_t>(r);
    failed[unit] = jobs[j].kind->run(trial, jobs[j].bias).verdict != jobs[j].right ? 1 : 0;
  };
  for_each_unit(units.size(), threads, one, progress);
  for (std::size_t u = 0; u < units.size(); ++u) outcomes[units[u].first].failures += failed[u];
  return outcomes;
}

double normal_draw(double u) { return boost::math::quantile(boost::math::normal(), (u * 0x1p53 + 0.5) * 0x1p-53); }

// The two-sided p-value of a z-test of the mean of 20 normal draws, under the standard deviation
// `sigma`.
double z_test(PhiloxStream<double>& source, double sigma) {
  double sum = 0;
  for (int i = 0; i < 20; ++i) sum += normal_draw(source.next());
  return 2 * cdf(complement(boost::math::normal(), std::abs(sum) / (sigma * std::sqrt(20.0))));
}

double t_test(PhiloxStream<double>& source) {
  std::vector<double> draws(20);
  for (double& x : draws) x = normal_draw(source.next());
  const Moments moments = Moments::of(draws);
  return 2 * cdf(complement(boost::math::students_t(19), std::abs(moments.mean()) / moments.standard_error()));
}

double chi_square_test(PhiloxStream<double>& source) {
  std::vector<std::uint64_t> counts(16);
  for (int i = 0; i < 4096; ++i) ++counts[static_cast<std::size_t>(16 * source.next())];
  return chi_square(counts, std::vector<double>(16, 1.0 / 16)).too_far;
}

}  // namespace

int binomial_limit(int runs, double probability) {
  const boost::math::binomial law(runs, probability);
  int k = 0;
  while (k < runs && cdf(complement(law, k)) > chance) ++k;
  return k;
}

std::vector<TesterOutcome> audit_calibration(const TesterAudit& audit, const Progress& progress) {
  const int limit = binomial_limit(audit.calibration_runs, calibration_level);
  std::vector<Job> jobs;
  for (const TestKind& kind : test_kinds()) {
    const Trial trial{"calibration." + kind.name, 0, calibration_level, 0.01, audit_margin};
    jobs.push_back({&kind, kind.name, 0, trial, Verdict::certified, audit.calibration_runs, limit});
  }
  return run_jobs(jobs, audit.seed, audit.threads, progress);
}

std::vector<TesterOutcome> audit_power(const TesterAudit& audit, const Progress& progress) {
  std::vector<Job> jobs;
  for (const TestKind& kind : test_kinds()) {
    for (double bias : {audit_margin, -audit_margin}) {
      if (kind.one_sided && bias < 0) continue;
      for (double beta : {1e-8, 1e-2}) {
        const std::string name =
            kind.name + (bias > 0 ? " +" : " -") + (beta < 1e-3 ? " miss rate 1e-8" : " miss rate 0.01");
        const Trial trial{"power." + name, 0, 1e-6, beta, audit_margin};
        const int limit = beta < 1e-3 ? 0 : binomial_limit(audit.power_seeds, beta);
        const Verdict right = kind.refutes ? Verdict::biased : Verdict::undecided;
        jobs.push_back({&kind, name, bias, trial, right, audit.power_seeds, limit});
      }
    }
  }
  return run_jobs(jobs, audit.seed, audit.threads, progress);
}

std::vector<CostOutcome> audit_cost(const TesterAudit& audit, const Progress& progress) {
  const auto& laws = cost_laws();
  const auto runs = static_cast<std::size_t>(audit.cost_runs);
  std::vector<double> draws(laws.size() * runs);
  const auto one = [&](std::size_t i) {
    const CostLaw& law = laws[i / runs];
    const Trial trial{"cost." + law.name, audit.seed + i % runs, 1e-8, 0.01, law.margin};
    draws[i] = static_cast<double>(bet_on(law, trial, 0).draws);
  };
  for_each_unit(draws.size(), audit.threads, one, progress);
  std::vector<CostOutcome> outcomes;
  for (std::size_t l = 0; l < laws.size(); ++l) {
    const Moments moments = Moments::of(std::span(draws).subspan(l * runs, runs));
    const double unit = laws[l].margin * laws[l].margin / laws[l].cv2;
    outcomes.push_back({laws[l].name, moments.mean() * unit, moments.standard_error() * unit, laws[l].limit});
  }
  return outcomes;
}

double fixed_size_cost(double alpha, double beta) {
  const boost::math::normal normal;
  const double root = quantile(complement(normal, alpha / 2)) + quantile(complement(normal, beta));
  return root * root;
}

std::vector<UniformityOutcome> audit_uniformity(const TesterAudit& audit) {
  const auto judge_p = [&](const std::string& name, bool expected, const auto& test) {
    const StreamKey key(audit.seed, "uniformity." + name);
    std::vector<double> p_values(static_cast<std::size_t>(audit.p_values));
    for (std::size_t i = 0; i < p_values.size(); ++i) {
      PhiloxStream<double> source(key, 0, i);
      p_values[i] = test(source);
    }
    // The wrong sigma is about 7.6 standard errors off at 10^4 p-values. A level of 1e-3 misses it
    // once in 30 000 audits, a level of 1e-6 once in 200.
    const Uniformity result = uniformity(p_values, expected ? 1e-6 : 1e-3);
    const double least = std::min({result.fisher_small, result.fisher_large, result.distance});
    return UniformityOutcome{name, audit.p_values, least, expected, result.uniform};
  };
  return {judge_p("z-test", true, [](auto& source) { return z_test(source, 1); }), judge_p("t-test", true, t_test),
          judge_p("chi-square", true, chi_square_test),
          judge_p("z-test, sigma 5 % too small", false, [](auto& source) { return z_test(source, 0.95); })};
}

}  // namespace fairlight
