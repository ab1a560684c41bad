#include <algorithm>
#include <cmath>

#include <fairlight/stats/channel_findings.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/means.h>

namespace fairlight {
namespace {

constexpr std::size_t independent_pilot = 1024, replicate_pilot = 64;

std::vector<Reference> with_share(std::vector<Reference> references, double share) {
  for (Reference& r : references) {
    r.scale *= share;
    r.rounding /= share;
  }
  return references;
}

bool is_heard(const Trial& trial) { return trial.evidence != nullptr && trial.evidence->listener; }

// The finding of a pilot that met a draw which the claim excludes.
Finding refuted_in_pilot(const Trial& trial, std::size_t channels, const BadDraw& bad) {
  if (trial.evidence != nullptr) trial.evidence->margin_grid = refuted_grid(trial.margin, channels);
  return detail::found_in_pilot(trial, bad);
}

}  // namespace

std::uint32_t points_for(const std::vector<Reference>& references) {
  const auto wide = [](const Reference& r) { return r.upper - r.lower > 8 * std::abs(r.scale); };
  return std::ranges::any_of(references, wide) ? points_a_replicate / 4 : points_a_replicate;
}

Finding check_mean(const Trial& trial, const std::vector<Reference>& references, const Draws& draws) {
  return test_means(trial, rounded_references(references, draws.rounding),
                    draws.independent(StreamKey(trial.seed, trial.claim)));
}

PacketMean::PacketMean(const Trial& trial, const std::vector<Reference>& references, const Draws& draws)
    : trial_(trial), references_(rounded_references(references, draws.rounding)), draws_(draws) {}

std::vector<Reference> PacketMean::references(const SamplingScheme& scheme, double share) const {
  return with_share(scheme.is_independent() ? references_ : replicate_references(references_, scheme.points),
                    share);
}

// A tail slack of the draws also bounds that of their means, by Jensen's inequality.
DrawBlock PacketMean::draws(const SamplingScheme& scheme, const std::string& purpose) const {
  const StreamKey key(trial_.seed, trial_.claim + (scheme.is_independent() ? "" : " over points") + purpose);
  return scheme.is_independent() ? draws_.independent(key) : draws_.replicates(key, references_, scheme.points);
}

std::vector<Finding> PacketMean::test_each(const Trial& trial, const SamplingScheme& scheme, double share) const {
  std::vector<Finding> findings = test_each_mean(trial, references(scheme, share), draws(scheme, ""));
  for (Finding& each : findings) each.draws *= scheme.points;
  return findings;
}

SamplingScheme PacketMean::cheapest(double many) const {
  Pilots pilots(*this);
  if (static_cast<double>(draws_.lanes) * pilots.independent(1).cost <= many) return {};
  pilots.add_points();
  return pilots.cheapest(1).scheme;
}

PacketMean::Pilots::Pilots(const PacketMean& mean) : mean_(mean) { add({}, 1, independent_pilot); }

void PacketMean::Pilots::add_points() {
  for (const std::uint32_t points : replicate_sizes) add({points}, 1.5 * points, replicate_pilot);
}

void PacketMean::Pilots::add(const SamplingScheme& scheme, double packets, std::size_t draws) {
  std::vector channels(mean_.references_.size(), std::vector<double>(draws));
  mean_.draws(scheme, " pilot")(0, channels);
  seen_.push_back({scheme, packets, std::move(channels)});
}

PacketMean::Choice PacketMean::Pilots::choice(const Seen& seen, double share) const {
  const double draws = expected_draws(mean_.trial_, mean_.references(seen.scheme, share), seen.channels);
  return {seen.scheme, seen.packets * draws / static_cast<double>(mean_.draws_.lanes)};
}

PacketMean::Choice PacketMean::Pilots::independent(double share) const { return choice(seen_.front(), share); }

PacketMean::Choice PacketMean::Pilots::cheapest(double share) const {
  Choice best = independent(share);
  for (const Seen& seen : seen_) {
    if (const Choice other = choice(seen, share); other.cost < best.cost) best = other;
  }
  return best;
}

// A listener gets draws from independent numbers, as pictures are made of these.
Finding check_mean_in_packets(const Trial& trial, const std::vector<Reference>& references, const Draws& draws,
                              double many) try {
  const PacketMean mean(trial, references, draws);
  const SamplingScheme scheme = is_heard(trial) ? SamplingScheme() : mean.cheapest(many);
  Finding finding = worst_of(mean.test_each(trial, scheme));
  if (!scheme.is_independent() && finding.verdict != Verdict::certified)
    finding.note = "tested over Sobol' points" + (finding.note.empty() ? "" : ": " + finding.note);
  return finding;
} catch (const BadDraw& bad) {
  return refuted_in_pilot(trial, references.size(), bad);
}

Finding check_mean_in_double(const Trial& trial, const std::vector<Reference>& references,
                             const PairedDraws& draws) try {
  if (!is_heard(trial)) {
    const PacketControlVariate variate(trial, references, draws);
    if (const auto plan = variate.pays()) return variate.finding(*plan);
  }
  return check_mean(trial, references, draws.in_double);
} catch (const BadDraw& bad) {
  return refuted_in_pilot(trial, references.size(), bad);
}

}  // namespace fairlight
