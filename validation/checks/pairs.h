#pragma once

#include <cstdint>
#include <functional>

#include <fairlight/estimators/stream.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {

/// The numbers that samplers draw from: points of the unit square for draws i, i + 1, ..., one for
/// each lane.
template <class Real>
using Pairs = std::function<Vec2<Real>(std::uint64_t i)>;

/// The first two independent numbers of each draw.
template <class Real>
Pairs<Real> independent_pairs(const StreamKey& key);

/// Sobol' points, in consecutive replicates of n. Throws std::invalid_argument unless a replicate
/// fills whole packets.
template <class Real>
Pairs<Real> point_pairs(const StreamKey& key, std::uint32_t n);

extern template Pairs<double> independent_pairs(const StreamKey&);
extern template Pairs<Packet> independent_pairs(const StreamKey&);
extern template Pairs<double> point_pairs(const StreamKey&, std::uint32_t);
extern template Pairs<Packet> point_pairs(const StreamKey&, std::uint32_t);

}  // namespace fairlight
