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

/// How the numbers of a packet's draws are spread: each draw for itself; or each the mean of several in a row, where a draw can be made
/// so, or over a replicate of points. The mean is the same, but it varies less, or takes less time.
struct Spread {
  std::uint32_t count = 1;  ///< of draws that one is the mean of
  bool over_points = false;
};

/// The mean of `draw(type_identity<Packet>, source)`, from numbers that are spread so or so. One that has `in_a_row` as RadianceAlong has it is
/// drawn so too.
/// Source   Owen 1995 (the points)
template <class Draw>
class PacketMean {
 public:
  /// How many points a replicate may have; there are few where the range is so wide that it says how many replicates there must be.
  static constexpr std::array<std::uint32_t, 2> set_sizes{points_a_replicate / 4, points_a_replicate};

  PacketMean(const Trial& trial, const std::vector<Reference>& references, const Draw& draw)
      : trial_(trial), references_(rounded_references<Packet>(references)), draw_(draw) {}

  /// What is claimed of draws, where the mean has this share of the margin.
  std::vector<Reference> references(const Spread& spread, double share) const {
    return detail::with_share(spread.count == 1 ? references_ : replicate_references(references_, spread.count),
                              share);
  }

  struct Choice {
    Spread spread;
    double cost;  ///< in packets
  };

  /// What a few draws say of all, however the numbers are spread.
  class Pilots {
   public:
    /// Each draw for itself, for a mean that has this share of the margin. Throws BadDraw for a draw that its reference rules out.
    Choice one_by_one(double share) const { return cost(0, share); }

    /// What takes the least time.
    Choice cheapest(double share) const {
      Choice best = one_by_one(share);
      for (std::size_t i = 1; i < seen_.size(); ++i) {
        if (const Choice other = cost(i, share); other.cost < best.cost) best = other;
      }
      return best;
    }

    /// So that paths in a row are among what is weighed, if there are any.
    void add_rows() {
      if (can_be_in_a_row) add({paths_in_a_row}, mean_.packets_of_a_row(), 128);
    }

    /// And points. Two packets of points are taken to cost what three others do.
    void add_sets() {
      for (const std::uint32_t points : set_sizes) add({points, true}, 1.5 * points, 64);
    }

   private:
    friend PacketMean;
    using Channels = std::vector<std::vector<double>>;

    struct Seen {
      Spread spread;
      double packets;  ///< what as many draws cost as a packet has lanes
      Channels channels;
    };

    explicit Pilots(const PacketMean& mean) : mean_(mean) { add({}, 1, 1024); }

    void add(const Spread& spread, double packets, std::size_t draws) {
      Channels channels(mean_.references_.size(), std::vector<double>(draws));
      mean_.draws(spread, " pilot")(0, channels);
      seen_.push_back({spread, packets, std::move(channels)});
    }

    Choice cost(std::size_t i, double share) const {
      const Seen& seen = seen_[i];
      const double draws = expected_draws(mean_.trial_, mean_.references(seen.spread, share), seen.channels);
      return {seen.spread, seen.packets * draws / lanes<Packet>};
    }

    const PacketMean& mean_;
    std::vector<Seen> seen_;
  };

  /// Of draws one by one.
  Pilots pilots() const& { return Pilots(*this); }

  /// What takes the least time for a mean that has all of the margin: over points only where independent numbers would take more than so many
  /// draws. One by one where a pilot is out of its range.
  Spread cheapest(double many) const try {
    Pilots pilots(*this);
    pilots.add_rows();
    if (lanes<Packet> * pilots.one_by_one(1).cost > many) pilots.add_sets();
    return pilots.cheapest(1).spread;
  } catch (const BadDraw&) {
    return {};
  }

  /// What test_means finds of each channel, and throws, its draws counted one by one. The levels are those of this trial, the numbers those of
  /// the mean's own.
  std::vector<Finding> test_each(const Trial& trial, const Spread& spread, double share = 1) const {
    std::vector<Finding> findings = test_each_mean(trial, references(spread, share), draws(spread, ""));
    for (Finding& each : findings) each.draws *= spread.count;
    return findings;
  }

 private:
  using Ignored = decltype([](const Mask<Packet>&, const Rgb<Packet>&) {});
  static constexpr bool can_be_in_a_row = requires(const Draw& draw, StreamNumbers<Packet>& source) {
    draw.in_a_row(1, source, Ignored());
  };
  static constexpr std::uint32_t paths_in_a_row = 8;

  // What paths in a row cost, in packets of one path a lane: by the numbers that they take.
  double packets_of_a_row() const {
    double one_by_one = 0, row = 0;
    if constexpr (can_be_in_a_row) {
      const StreamKey key(trial_.seed, trial_.claim + " length");
      for (std::uint64_t first = 0; first < 8 * lanes<Packet>; first += lanes<Packet>) {
        StreamNumbers<Packet> numbers(key, first), others(key, first);
        draw_(std::type_identity<Packet>{}, numbers);
        draw_.in_a_row(paths_in_a_row, others, Ignored());
        one_by_one += static_cast<double>(numbers.drawn());
        row += static_cast<double>(others.drawn());
      }
    }
    return row > 0 ? row / one_by_one : paths_in_a_row;
  }

  // What a tail may hide of draws it may hide of their means, at most (Jensen).
  DrawBlock draws(const Spread& spread, const std::string& purpose) const {
    const auto in_packets = [draw = draw_](auto& source) { return draw(std::type_identity<Packet>{}, source); };
    const StreamKey key(trial_.seed, trial_.claim + (spread.over_points ? " over points" : "") + purpose);
    if (spread.over_points) return replicate_draws<OwenSobol<Packet>>(key, references_, in_packets, spread.count);
    if constexpr (can_be_in_a_row) {
      if (spread.count > 1) return row_draws(key, static_cast<int>(spread.count));
    }
    return independent_draws<Packet>(key, references_.size(), in_packets);
  }

  // Each of the paths that a draw is the mean of is held to its range. What their sum in floats rounds, rounded_references leaves room for.
  DrawBlock row_draws(const StreamKey& key, int count) const requires can_be_in_a_row {
    Rgb<Packet> inside;
    for (std::size_t c = 0; c < 3; ++c)
      inside[static_cast<int>(c)] = Packet(static_cast<float>(references_.at(c).mean));
    return draws_at_once<Packet>(references_.size(), [key, count, inside, draw = draw_, references = references_](
                                                         std::uint64_t first, const auto& places) {
      StreamNumbers<Packet> source(key, first);
      Rgb<Packet> sum = zero<Rgb<Packet>>();
      draw.in_a_row(count, source, [&](const Mask<Packet>& ended, const Rgb<Packet>& found) {
        detail::require_in_range(first, Rgb<Packet>(select(ended, found, inside)), references, 1);
        sum += select(ended, found, zero<Rgb<Packet>>());
      });
      for (std::size_t c = 0; c < places.size(); ++c)
        store_lanes(Packet(sum[static_cast<int>(c)] / Packet(static_cast<float>(count))), places[c]);
    });
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
  const Spread spread = detail::is_heard(trial) ? Spread() : mean.cheapest(many);
  Finding finding = worst_of(mean.test_each(trial, spread));
  if (spread.over_points && finding.verdict != Verdict::certified)
    finding.note = detail::note_on("seen over Sobol' points", finding.note);
  return finding;
}

}  // namespace fairlight
