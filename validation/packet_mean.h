#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fairlight/estimators/sobol.h>
#include <fairlight/validation/packet_parts.h>

namespace fairlight {

/// The mean of `draw(type_identity<Packet>, source)` from independent numbers, or over replicates of Sobol's points: it does not depend on
/// how numbers are spread, and from points it varies less. A number of points says which: 1 where numbers are independent.
/// Source   Owen 1995 (the points)
template <class Draw>
class PacketMean {
 public:
  /// How many points a replicate may have; there are few where the range is so wide that it says how many replicates there must be.
  static constexpr std::array<std::uint32_t, 2> set_sizes{points_a_replicate / 4, points_a_replicate};

  PacketMean(const Trial& trial, const std::vector<Reference>& references, const Draw& draw)
      : trial_(trial), references_(rounded_references<Packet>(references)), draw_(draw) {}

  /// What is claimed of draws, where the mean has this share of the margin.
  std::vector<Reference> references(std::uint32_t points, double share) const {
    return detail::with_share(points == 1 ? references_ : replicate_references(references_, points), share);
  }

  struct Choice {
    std::uint32_t points;
    double cost;  ///< in packets
  };

  /// What a few draws say of all, however the numbers are spread.
  class Pilots {
   public:
    /// Independent numbers, for a mean that has this share of the margin. Throws BadDraw for a draw that its reference rules out.
    Choice independent(double share) const { return cost(0, share); }

    /// The points that take the least time. Two packets of points are taken to cost what three others do.
    Choice cheapest(double share) const {
      Choice best = independent(share);
      for (std::size_t i = 1; i < draws_.size(); ++i) {
        if (const Choice other = cost(i, share); other.cost < best.cost) best = other;
      }
      return best;
    }

    /// So that points are among the numbers that are weighed.
    void add_sets() {
      for (const std::uint32_t points : set_sizes) add(points, 64);
    }

   private:
    friend PacketMean;
    using Channels = std::vector<std::vector<double>>;

    explicit Pilots(const PacketMean& mean) : mean_(mean) { add(1, 1024); }

    void add(std::uint32_t points, std::size_t draws) {
      Channels channels(mean_.references_.size(), std::vector<double>(draws));
      mean_.draws(points, " pilot")(0, channels);
      draws_.emplace_back(points, std::move(channels));
    }

    Choice cost(std::size_t i, double share) const {
      const auto& [points, channels] = draws_[i];
      const double draws = expected_draws(mean_.trial_, mean_.references(points, share), channels);
      return {points, (points == 1 ? 1 : 1.5 * points) * draws / lanes<Packet>};
    }

    const PacketMean& mean_;
    std::vector<std::pair<std::uint32_t, Channels>> draws_;
  };

  Pilots independent_pilots() const& { return Pilots(*this); }

  /// Which points take the least time for a mean that has all of the margin, where independent numbers would take more than so many draws;
  /// independent ones where a pilot is out of its range.
  std::uint32_t cheapest_points(double many) const try {
    Pilots pilots(*this);
    const double draws = lanes<Packet> * pilots.independent(1).cost;
    if (draws > many) pilots.add_sets();
    return pilots.cheapest(1).points;
  } catch (const BadDraw&) {
    return 1;
  }

  /// What test_means finds of each channel, and throws, its draws counted one by one. The levels are those of this trial, the numbers those of
  /// the mean's own.
  std::vector<Finding> test_each(const Trial& trial, std::uint32_t points, double share = 1) const {
    std::vector<Finding> findings = test_each_mean(trial, references(points, share), draws(points, ""));
    for (Finding& each : findings) each.draws *= points;
    return findings;
  }

 private:
  // What a tail may hide of draws it may hide of their means, at most (Jensen).
  DrawBlock draws(std::uint32_t points, const std::string& purpose) const {
    const auto in_packets = [draw = draw_](auto& source) { return draw(std::type_identity<Packet>{}, source); };
    const StreamKey key(trial_.seed, trial_.claim + (points == 1 ? "" : " over points") + purpose);
    return points == 1 ? independent_draws<Packet>(key, references_.size(), in_packets)
                       : replicate_draws<OwenSobol<Packet>>(key, references_, in_packets, points);
  }

  Trial trial_;
  std::vector<Reference> references_;
  Draw draw_;
};

namespace detail {

/// Whether somebody listens, who is to hear the draws themselves.
inline bool is_heard(const Trial& trial) { return trial.evidence != nullptr && trial.evidence->listener; }

}  // namespace detail

/// The mean of an estimator in packets. Independent numbers, which pictures are made of, are themselves held to account where they are drawn
/// with; so points stand in only where it would take more than `many` of them, which hardly happens at a margin of 1e-3, and not where
/// somebody listens. Throws what test_means does.
template <class Draw>
Finding check_mean_in_packets(const Trial& trial, const std::vector<Reference>& references, const Draw& draw,
                              double many = 1 << 27) {
  const PacketMean mean(trial, references, draw);
  const std::uint32_t points = detail::is_heard(trial) ? 1 : mean.cheapest_points(many);
  Finding finding = worst_of(mean.test_each(trial, points));
  if (points > 1 && finding.verdict != Verdict::certified)
    finding.note = detail::note_on("seen over Sobol' points", finding.note);
  return finding;
}

}  // namespace fairlight
