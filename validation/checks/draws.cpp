// The program compiles this file once for double, and once for each instruction set.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <fairlight/estimators/sobol.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/draws.h>

namespace fairlight {
namespace {

template <class Real>
std::array<double, lanes<Real>> in_double(const Real& x) {
  std::array<double, lanes<Real>> values{};
  store_lanes(x, values.data());
  return values;
}

// Checks each draw of a replicate. `draw` is the number of the replicate, the same for all lanes.
template <class Real>
void require_in_range(std::uint64_t draw, const std::vector<Real>& channels,
                      const std::vector<Reference>& references) {
  for (std::size_t c = 0; c < references.size(); ++c) {
    const double lower = references[c].lower;
    const double upper = references[c].tail_slack > 0 ? infinity<double> : references[c].upper;
    if (!any(!(channels[c] >= rounded<Real>(lower) && channels[c] <= rounded<Real>(upper)))) continue;
    for (const double value : in_double(channels[c])) {
      if (!(value >= lower && value <= upper))
        throw BadDraw(
            draw, value,
            formatted("one of those that it is the mean of, out of its declared range from %g to %g", lower, upper)
                .c_str());
    }
  }
}

void require_in_range(std::uint64_t draw, double value, const Reference& reference) {
  if (!std::isfinite(value)) throw BadDraw(draw, value, "in double, not a finite number");
  if (value < reference.lower) throw BadDraw(draw, value, "in double, below its declared lower bound");
  if (value > reference.upper && reference.tail_slack == 0)
    throw BadDraw(draw, value, "in double, above its declared upper bound");
}

template <class Real>
DrawBlock independent_draws(std::shared_ptr<const Body<Real>> body, const StreamKey& key,
                            std::size_t channel_count) {
  const auto make = [body, numbers = std::make_shared<IndependentSamples<Real>>(key),
                     channels = std::vector<Real>(channel_count)](std::uint64_t first,
                                                                  std::span<double* const> places) mutable {
    numbers->move_to(first);
    NumberSource<Real> source(*numbers);
    body->draw(source, channels);
    for (std::size_t c = 0; c < places.size(); ++c) store_lanes(channels[c], places[c]);
  };
  return draws_at_once(lanes<Real>, channel_count, make);
}

// Sums the packets of a replicate in their own arithmetic, then the lanes in double.
template <class Real>
std::vector<double> replicate_mean(PointNumbers<Real>& numbers, const Body<Real>& body, std::uint64_t replicate,
                                   const std::vector<Reference>& references, std::uint32_t n) {
  std::vector<Real> sums(references.size(), Real(0)), channels(references.size());
  for (std::uint32_t i = 0; i < n; i += static_cast<std::uint32_t>(lanes<Real>)) {
    numbers.move_to(i);
    NumberSource<Real> source(numbers);
    body.draw(source, channels);
    require_in_range(replicate, channels, references);
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += channels[c];
  }
  std::vector<double> means;
  for (const Real& sum : sums) {
    const auto values = in_double(sum);
    means.push_back(std::accumulate(values.begin(), values.end(), 0.0) / n);
  }
  return means;
}

// A packet of draws whose lanes can each be drawn again in double.
template <class Packets>
class FollowedLanes {
 public:
  FollowedLanes(const StreamKey& key, std::uint64_t first, const Body<Packets>& body, std::size_t channel_count)
      : key_(key), first_(first), floats_(key, first), finer_(floats_, key, first), channels_(channel_count) {
    NumberSource<Packets> source(floats_);
    body.draw(source, channels_);
    drawn_ = source.drawn();
  }

  const std::vector<Packets>& packet() const { return channels_; }
  std::size_t drawn() const { return drawn_; }

  /// Draws one lane in double, and returns how many numbers it took.
  std::size_t follow(std::size_t lane, const Body<double>& body, std::vector<double>& channels) {
    LaneNumbers<Packets> numbers(finer_, lane);
    NumberSource<double> source(numbers);
    body.draw(source, channels);
    return source.drawn();
  }

 private:
  StreamKey key_;
  std::uint64_t first_;
  IndependentSamples<Packets> floats_;
  FinerNumbers<Packets> finer_;
  std::vector<Packets> channels_;
  std::size_t drawn_;
};

template <class Packets>
DrawBlock difference_draws(std::shared_ptr<const Body<double>> doubles,
                           std::shared_ptr<const Body<Packets>> packets, const StreamKey& key,
                           const std::vector<Reference>& references) {
  const auto make = [=](std::uint64_t first, std::span<double* const> places) {
    FollowedLanes<Packets> lane_by_lane(key, first, *packets, references.size());
    std::vector<double> channels(references.size());
    for (std::size_t c = 0; c < places.size(); ++c) store_lanes(lane_by_lane.packet()[c], places[c]);
    for (std::size_t i = 0; i < lanes<Packets>; ++i) {
      lane_by_lane.follow(i, *doubles, channels);
      for (std::size_t c = 0; c < places.size(); ++c) {
        require_in_range(first + i, channels[c], references[c]);
        const double most = references[c].tail_slack > 0 ? references[c].upper : infinity<double>;
        places[c][i] = std::min(channels[c], most) - std::min(places[c][i], most);
      }
    }
  };
  return draws_at_once(lanes<Packets>, references.size(), make);
}

template <class Packets>
double numbers_of_packets_over_lanes(const Body<double>& doubles, const Body<Packets>& packets,
                                     const StreamKey& key, std::size_t channel_count) {
  std::size_t by_packets = 0, by_lanes = 0;
  std::vector<double> channels(channel_count);
  for (std::uint64_t first = 0; first < 32 * lanes<Packets>; first += lanes<Packets>) {
    FollowedLanes<Packets> lane_by_lane(key, first, packets, channel_count);
    by_packets += lanes<Packets> * lane_by_lane.drawn();
    for (std::size_t i = 0; i < lanes<Packets>; ++i) by_lanes += lane_by_lane.follow(i, doubles, channels);
  }
  return by_lanes > 0 ? static_cast<double>(by_packets) / static_cast<double>(by_lanes) : 1;
}

}  // namespace

template <class Real>
DrawBlock replicate_draws(std::shared_ptr<PointNumbers<Real>> numbers, std::shared_ptr<const Body<Real>> body,
                          const StreamKey& key, const std::vector<Reference>& references, std::uint32_t n) {
  if (n % lanes<Real> != 0)
    throw std::invalid_argument("a replicate must fill whole packets (give a multiple of lanes)");
  return [=](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      numbers->begin(key, number_in_key(first + i, "replicates"), n);
      const std::vector<double> means = replicate_mean(*numbers, *body, first + i, references, n);
      for (std::size_t c = 0; c < channels.size(); ++c) channels[c][i] = means[c];
    }
  };
}

template <class Real>
Draws draws_of(std::shared_ptr<const Body<Real>> body, std::size_t channels) {
  return {lanes<Real>, arithmetic_rounding<Real>,
          [=](const StreamKey& key) { return independent_draws(body, key, channels); },
          [=](const StreamKey& key, const std::vector<Reference>& references, std::uint32_t n) {
            const auto points = std::make_shared<PointNumbersOf<OwenSobol<Real>>>();
            return replicate_draws<Real>(points, body, key, references, n);
          }};
}

template <class Packets>
PairedDraws paired_draws(std::shared_ptr<const Body<double>> in_double,
                         std::shared_ptr<const Body<Packets>> in_packets, std::size_t channels) {
  return {
      draws_of(in_double, channels), draws_of(in_packets, channels),
      [=](const StreamKey& key, const std::vector<Reference>& references) {
        return difference_draws(in_double, in_packets, key, references);
      },
      [=](const StreamKey& key) { return numbers_of_packets_over_lanes(*in_double, *in_packets, key, channels); }};
}

template Draws draws_of(std::shared_ptr<const Body<Packet>>, std::size_t);
template PairedDraws paired_draws(std::shared_ptr<const Body<double>>, std::shared_ptr<const Body<Packet>>,
                                  std::size_t);
template DrawBlock replicate_draws(std::shared_ptr<PointNumbers<Packet>>, std::shared_ptr<const Body<Packet>>,
                                   const StreamKey&, const std::vector<Reference>&, std::uint32_t);
#if !defined(FAIRLIGHT_ENTRY)  // double needs no instruction set of its own
template Draws draws_of(std::shared_ptr<const Body<double>>, std::size_t);
template DrawBlock replicate_draws(std::shared_ptr<PointNumbers<double>>, std::shared_ptr<const Body<double>>,
                                   const StreamKey&, const std::vector<Reference>&, std::uint32_t);
#endif

}  // namespace fairlight
