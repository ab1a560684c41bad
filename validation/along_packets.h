#pragma once

#include <cmath>

#include <fairlight/stats/evidence.h>
#include <fairlight/validation/checks.h>

namespace fairlight {

/// What draws in double have more than those in packets, lane by lane from the same numbers: `draw(type_identity<Real>, source)`. What a
/// channel, of which there are as many, has above its `most` does not count.
template <class Draw>
DrawBlock less_packets(const StreamKey& key, const std::vector<double>& most, const Draw& draw) {
  return draws_at_once<Packet>(most.size(), [key, most, draw](std::uint64_t first, auto& values) {
    Recording recording(key, first);
    StreamNumbers<Packet> numbers(recording);
    const auto floats = draw(std::type_identity<Packet>{}, numbers);
    for (std::size_t c = 0; c < values.size(); ++c) store_lanes(detail::channel_of(floats, c), values[c].data());
    for (std::size_t i = 0; i < lanes<Packet>; ++i) {
      StreamNumbers<double> finer_numbers(key, recording, i);
      const auto doubles = draw(std::type_identity<double>{}, finer_numbers);
      for (std::size_t c = 0; c < values.size(); ++c) {
        const double in_double = detail::channel_of(doubles, c);
        values[c][i] = std::min(in_double, most[c]) -
                       std::min(values[c][i], most[c]);  // of what is no number neither is the least
      }
    }
  });
}

/// A mean in double, most of it seen in packets: E[double] = E[packet] + E[double - packet]. Packets draw some ten times as fast, and
/// along the same numbers the difference is next to nothing, so that few draws show its mean. Both parts must be certified, each
/// to a share of the margin, and each has half of alpha.
/// Source   Hammersley and Handscomb 1964, 5.5 (the control variate)

namespace detail {

/// The packets' share of the margin. What is left of a margin of 1e-4 is four times the rounding of floats, the least that a test
/// by betting takes.
inline constexpr double share_of_packets = 0.79;

/// References to which the trial's margin is a share of what it was, and a bias so much more.
inline std::vector<Reference> with_share(std::vector<Reference> references, double share) {
  for (Reference& r : references) {
    r.scale *= share;
    r.rounding /= share;
  }
  return references;
}

/// Above it what a channel has does not count for the difference: where a tail is beyond the bound, its mean is the slack at most.
inline std::vector<double> most_of(const std::vector<Reference>& references) {
  std::vector<double> most;
  for (const Reference& r : references) most.push_back(r.tail_slack > 0 ? r.upper : infinity<double>);
  return most;
}

/// Of the difference of a draw in double from one in packets, where both have these references. Tails may hide twice their slack, which the
/// margin is narrowed by, and is no bias.
inline std::vector<Reference> of_difference(const std::vector<Reference>& references, double margin) {
  const std::vector<Reference> packets = rounded_references<Packet>(references);
  std::vector<Reference> differences;
  for (std::size_t c = 0; c < references.size(); ++c) {
    const Reference &r = references[c], &p = packets[c];
    const double hidden = 2 * r.tail_slack / r.scale;
    differences.push_back(
        {.mean = 0,
         .lower = r.lower - p.upper,
         .upper = r.upper - p.lower,
         .scale = r.scale * (1 - share_of_packets - hidden / margin),
         .rounding = (arithmetic_rounding<Packet> + hidden) / (1 - share_of_packets - hidden / margin)});
  }
  return differences;
}

inline double log_of_mean(double log_a, double log_b) {
  const double top = std::max(log_a, log_b);
  return std::isinf(top) ? top : top + std::log((std::exp(log_a - top) + std::exp(log_b - top)) / 2);
}

/// What two parts say of the whole. A whole that is off by its margin has a part that is off by its share, so the less wealth of
/// the two is held against that; both parts are right where the whole is claimed to be, so the mean is held against the claim.
inline Wealth joint(const Wealth& a, const Wealth& b) {
  return {log_of_mean(a.too_bright, b.too_bright), log_of_mean(a.too_dark, b.too_dark),
          std::min(a.not_brighter, b.not_brighter), std::min(a.not_darker, b.not_darker)};
}

inline Ladder joint(Ladder a, const Ladder& b) {
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    for (std::size_t r = 0; r < a.channels[c].size(); ++r) {
      a.channels[c][r] = joint(a.channels[c][r], b.channels.empty() ? Wealth{} : b.channels[c][r]);
    }
  }
  return a;
}

/// What two parts found, of the whole.
inline Finding sum_of(const Trial& trial, const Finding& packets, const Finding& differences) {
  const double p = share_of_packets, d = 1 - share_of_packets;
  Finding sum = packets;
  sum.verdict = worse(packets.verdict, differences.verdict);
  sum.margin = trial.margin;
  sum.bias = p * packets.bias + d * differences.bias;
  sum.interval = {p * packets.interval.lo + d * differences.interval.lo,
                  p * packets.interval.hi + d * differences.interval.hi};
  sum.draws += differences.draws;
  sum.rounding = p * packets.rounding + d * differences.rounding;
  if (!differences.note.empty()) sum.note = differences.note;
  return sum;
}

}  // namespace detail

/// The mean of `draw(type_identity<Real>, source)`, in double, along its draws in packets.
template <class Draw>
class AlongPackets {
 public:
  AlongPackets(const Trial& trial, const std::vector<Reference>& references, const Draw& draw)
      : trial_(trial),
        draw_(draw),
        references_(references),
        packets_(detail::with_share(rounded_references<Packet>(references), detail::share_of_packets)),
        differences_(detail::of_difference(references, trial.margin)) {}

  /// Whether it takes less time than double alone, as a pilot foresees: not where the range is so wide that it alone says how many
  /// draws there must be. A packet is taken to cost what a draw in double does. A pilot that is out of its range is left to double.
  bool pays() const try {
    for (std::size_t c = 0; c < references_.size(); ++c) {
      const double share = differences_[c].scale / references_[c].scale;
      const bool tail_hides_much = share < 0.999 * (1 - detail::share_of_packets);
      if (references_[c].sides != Sides::both || tail_hides_much || differences_[c].rounding > trial_.margin / 4)
        return false;
    }
    const auto pilot = [this](std::size_t draws, const DrawBlock& draw_block) {
      std::vector channels(references_.size(), std::vector<double>(draws));
      draw_block(0, channels);
      return channels;
    };
    const auto draws = pilot(4096, packet_draws(" pilot"));
    const double alone = expected_draws(trial_, rounded_references<Packet>(references_), draws);
    const double in_packets = expected_draws(trial_, packets_, draws) / lanes<Packet>;
    if (in_packets > alone) return false;
    const auto differences = pilot(512, difference_draws(" pilot"));
    return in_packets + (1 + 1.0 / lanes<Packet>)*expected_draws(trial_, differences_, differences) < alone;
  } catch (const BadDraw&) {
    return false;
  }

  /// Throws what test_means does.
  Finding finding() const {
    Evidence packets, differences;
    if (trial_.evidence != nullptr && trial_.evidence->listener) {
      packets.listener = [this](const std::vector<Reference>&, const DrawBlock& draw_block, std::uint64_t draws) {
        trial_.evidence->listener(references_, draw_block, draws);
      };
    }
    Finding first = test_means(part(0, packets), packets_, packet_draws(""));
    Finding second{.verdict = Verdict::certified};
    if (first.verdict == Verdict::certified) {
      second = test_means(part(1, differences), differences_, difference_draws(""));
      if (second.verdict != Verdict::certified) second.note.insert(0, "less its draws in packets of floats: ");
    } else {
      first.note.insert(0, "in packets of floats, which it is drawn along: ");
    }
    leave(packets, differences);
    return detail::sum_of(trial_, first, second);
  }

 private:
  // The trial of the first part, or the second.
  Trial part(int i, Evidence& evidence) const {
    Trial part = trial_;
    part.alpha /= 2;
    part.evidence = trial_.evidence == nullptr ? nullptr : &evidence;
    if (trial_.watch) part.watch = [this, i](double done) { return goes_on(trial_, (i + done) / 2); };
    return part;
  }

  DrawBlock packet_draws(const std::string& purpose) const {
    const StreamKey key(trial_.seed, trial_.claim + purpose);
    return independent_draws<Packet>(key, references_.size(), [draw = draw_](auto& source) {
      return draw(std::type_identity<Packet>{}, source);
    });
  }

  DrawBlock difference_draws(const std::string& purpose) const {
    return less_packets(StreamKey(trial_.seed, trial_.claim + " in double" + purpose), detail::most_of(references_),
                        draw_);
  }

  void leave(const Evidence& packets, const Evidence& differences) const {
    if (trial_.evidence == nullptr) return;
    trial_.evidence->ladder = detail::joint(packets.ladder, differences.ladder);
    for (const Evidence* each : {&packets, &differences}) {
      trial_.evidence->means.insert(trial_.evidence->means.end(), each->means.begin(), each->means.end());
    }
  }

  Trial trial_;
  Draw draw_;
  std::vector<Reference> references_, packets_, differences_;
};

/// The mean of an estimator in double: along its draws in packets where that is faster.
template <class Draw>
Finding check_mean_in_double(const Trial& trial, const std::vector<Reference>& references, const Draw& draw) {
  const AlongPackets<Draw> along(trial, references, draw);
  if (along.pays()) return along.finding();
  return check_mean<double>(trial, references,
                            [&](auto& source) { return draw(std::type_identity<double>{}, source); });
}

}  // namespace fairlight
