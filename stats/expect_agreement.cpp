#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <fairlight/stats/channel_findings.h>
#include <fairlight/stats/dependence.h>
#include <fairlight/stats/expectation.h>
#include <fairlight/stats/sequential_t_test.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

using detail::EstimatorDraws;
using Channels = std::vector<std::vector<double>>;

// The draws of one of the two estimators, checked against its range.
class Side {
 public:
  Side(const char* name, const EstimatorDraws& draws, const Interval& range, Meter& meter,
       const Generator& generator, std::size_t channels)
      : name_(name), draws_(draws), range_(range), meter_(meter), generator_(generator), channels_(channels) {}

  const Channels& draw(std::size_t count) {
    for (auto& channel : channels_) channel.resize(count);
    draws_(generator_, meter_, channels_);
    for (const auto& channel : channels_) {
      for (std::size_t i = 0; i < count; ++i) check(channel[i], drawn_ + i);
    }
    drawn_ += count;
    lag_.add(channels_[0]);
    return channels_;
  }

  std::string warning() const {
    return lag_.warning().empty() ? "" : std::string("of ") + name_ + ", " + lag_.warning();
  }

 private:
  void check(double x, std::uint64_t i) const {
    if (!std::isfinite(x)) throw BadDraw(i, x, formatted("of %s, not a finite number", name_).c_str());
    if (!(x >= range_.lo && x <= range_.hi))
      throw BadDraw(i, x, formatted("of %s, outside its declared range", name_).c_str());
  }

  const char* name_;
  const EstimatorDraws& draws_;
  Interval range_;
  Meter& meter_;
  Generator generator_;
  Channels channels_;
  std::uint64_t drawn_ = 0;
  LagOne lag_;
};

// Lower bounds of the absolute means of b, each wrong with probability 1e-3, as scales of the
// margin. The pilot goes on until they are within a tenth, and has no other use.
std::vector<double> scales_of(Side& b, std::size_t channels) {
  constexpr std::uint64_t longest = 1u << 24;
  constexpr double enough = 30, least = 5, quantile = 3.1;  // standard errors
  std::vector<Moments> moments(channels);
  const auto known = [](const Moments& m, double errors) {
    return m.mean() != 0 && std::abs(m.mean()) >= errors * m.standard_error();
  };
  for (std::uint64_t count = 4096; moments[0].count() < longest;
       count = std::min<std::uint64_t>(2 * count, 65536)) {
    const Channels& drawn = b.draw(count);
    for (std::size_t c = 0; c < channels; ++c) moments[c].merge(Moments::of(drawn[c]));
    if (std::ranges::all_of(moments, [&](const Moments& m) { return known(m, enough); })) break;
  }
  std::vector<double> scales;
  for (const Moments& m : moments) {
    if (!known(m, least))
      throw std::invalid_argument(formatted(
          "the mean of b is %.1e with a standard error of %.1e, so a share of it is no margin (give one in the "
          "unit of the draws: fairlight::absolute(0.01), or as a share of a scale: fairlight::Margin(0.01, "
          "scale))",
          m.mean(), m.standard_error()));
    scales.push_back(std::abs(m.mean()) - quantile * m.standard_error());
  }
  return scales;
}

struct Pair {
  Side a, b;
  std::size_t channels;
};

std::vector<Finding> test_differences(const Trial& trial, const std::vector<double>& scales, Pair& pair,
                                      const std::array<Interval, 2>& ranges) {
  std::vector<Reference> references;
  for (double scale : scales)
    references.push_back({0, ranges[0].lo - ranges[1].hi, ranges[0].hi - ranges[1].lo, 0, scale});
  return test_each_mean(trial, references, [&](std::uint64_t, Channels& channels) {
    const Channels& of_a = pair.a.draw(channels[0].size());
    const Channels& of_b = pair.b.draw(channels[0].size());
    for (std::size_t c = 0; c < channels.size(); ++c)
      std::ranges::transform(of_a[c], of_b[c], channels[c].begin(), std::minus<>());
  });
}

Finding welch(const Trial& trial, double scale, Pair& pair, std::size_t channel) {
  Trial part = trial;
  part.alpha /= static_cast<double>(pair.channels);
  return sequential_welch_test(part, scale, [&](std::uint64_t, Channels& channels) {
    channels[0] = pair.a.draw(channels[0].size())[channel];
    channels[1] = pair.b.draw(channels[1].size())[channel];
  });
}

}  // namespace

Expectation detail::expect_agreement(const Site& site, std::size_t channels, const std::array<Interval, 2>& ranges,
                                     const Margin& margin, const Limits& limits,
                                     const std::array<EstimatorDraws, 2>& draws) {
  const Trial trial = trial_at(site, margin.share());
  const std::string claim = "the two means agree";
  Meter meter(limits);
  const auto side = [&](std::size_t i, const std::string& purpose) {
    return Side(i == 0 ? "a" : "b", draws[i], ranges[i], meter, generator_for(trial, purpose), channels);
  };
  Pair pair{side(0, "a"), side(1, "b"), channels};
  std::vector<double> scales(channels, 1);
  std::vector<Finding> findings;
  try {
    Side pilot = side(1, "pilot");
    scales = margin.has_scale() ? std::vector<double>(channels, margin.scale(0)) : scales_of(pilot, channels);
    const bool bounded = std::ranges::all_of(
        ranges, [](const Interval& range) { return std::isfinite(range.lo) && std::isfinite(range.hi); });
    if (bounded) {
      findings = test_differences(trial, scales, pair, ranges);
    } else {
      for (std::size_t c = 0; c < channels; ++c) findings.push_back(welch(trial, scales[c], pair, c));
    }
  } catch (const BadDraw& bad) {
    findings = {found_in_pilot(trial, bad)};
  } catch (const NoMoreDraws& spent) {
    findings = {found_in_pilot(trial, spent)};
  }
  const std::size_t c = worst_channel(findings);
  const auto difference = [&] { return pair.a.draw(1)[c][0] - pair.b.draw(1)[c][0]; };
  return judge(site, trial, channel_name(c, channels) + claim, findings[c],
               findings[c].verdict == Verdict::certified ? std::vector<double>() : sample_of(difference),
               {margin.unit(scales[c]), margin.unit_name(scales[c]), pair.a.warning() + pair.b.warning()});
}

}  // namespace fairlight
