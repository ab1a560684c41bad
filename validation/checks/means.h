#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fairlight/stats/evidence.h>
#include <fairlight/validation/checks/draws.h>

/// How the mean of an estimator is tested, and from which numbers. The verdict is always that of the core test.
namespace fairlight {

/// How many points a replicate has that is tested: a power of two, for Sobol's points to be a net, and few, since
/// the core test needs some 5 range / (margin mean) replicates however little they vary.
inline constexpr std::uint32_t points_a_replicate = 64;

/// As many; fewer where the range is so wide that it alone sets how many replicates there must be.
std::uint32_t points_for(const std::vector<Reference>& references);

/// From independent numbers, one reference per channel.
Finding check_mean(const Trial& trial, const std::vector<Reference>& references, const Draws& draws);

template <class Real = double, class Draw>
Finding check_mean(const Trial& trial, const std::vector<Reference>& references,
                   const Draw& draw) requires(!std::is_same_v<Draw, Draws>) {
  const auto body = body_of<Real>([draw](std::type_identity<Real>, auto& source) { return draw(source); });
  return check_mean(trial, references, draws_of<Real>(body, references.size()));
}

/// From the points of a set: whole replicates of n points are the draws of the core test.
template <PointSet Set>
Finding check_replicates(const Trial& trial, const std::vector<Reference>& references,
                         const std::shared_ptr<const Body<typename Set::Scalar>>& body, std::uint32_t n) {
  using Real = typename Set::Scalar;
  const std::vector<Reference> of_points = rounded_references<Real>(references);
  return test_means(trial, replicate_references(of_points, n),
                    replicate_draws<Real>(std::make_shared<PointNumbersOf<Set>>(), body,
                                          StreamKey(trial.seed, trial.claim), of_points, n));
}

/// Where the numbers of draws come from: each draw has independent ones; or it is the mean of a replicate of Sobol' points.
struct SamplingScheme {
  std::uint32_t points = 1;
  bool is_independent() const { return points == 1; }
};

/// The mean of draws in packets by either scheme: the mean is the same, but over points it varies less.
/// Source   Owen 1995 (the points)
class PacketMean {
 public:
  /// How many points a replicate may have; there are few where the range is so wide that it says how many replicates there
  /// must be.
  static constexpr std::array<std::uint32_t, 2> replicate_sizes{points_a_replicate / 4, points_a_replicate};

  PacketMean(const Trial& trial, const std::vector<Reference>& references, const Draws& draws);

  /// What is claimed of draws by a scheme, where the mean has this share of the margin.
  std::vector<Reference> references(const SamplingScheme& scheme, double share) const;

  struct Choice {
    SamplingScheme scheme;
    double cost;  ///< in packets
  };

  /// What a few draws say of how many a scheme takes.
  class Pilots {
   public:
    /// For a mean that has this share of the margin. Throws BadDraw for a draw that its reference rules out.
    Choice independent(double share) const;
    /// The scheme that takes the least time.
    Choice cheapest(double share) const;
    /// So that points are among what is weighed. Two packets of points are taken to cost what three others do.
    void add_points();

   private:
    friend PacketMean;
    struct Seen {
      SamplingScheme scheme;
      double packets;  ///< what as many draws cost as a packet has lanes
      std::vector<std::vector<double>> channels;
    };
    explicit Pilots(const PacketMean& mean);
    void add(const SamplingScheme& scheme, double packets, std::size_t draws);
    Choice choice(const Seen& seen, double share) const;

    const PacketMean& mean_;
    std::vector<Seen> seen_;
  };

  Pilots pilots() const& { return Pilots(*this); }

  /// What takes the least time for a mean that has all of the margin: points only where independent numbers would take more
  /// than so many draws. Independent ones where a pilot is out of its range.
  SamplingScheme cheapest(double many) const;

  /// What test_means finds of each channel, and throws, its draws counted one by one. The levels are those of this trial,
  /// the numbers those of the mean's own.
  std::vector<Finding> test_each(const Trial& trial, const SamplingScheme& scheme, double share = 1) const;

 private:
  DrawBlock draws(const SamplingScheme& scheme, const std::string& purpose) const;

  Trial trial_;
  std::vector<Reference> references_;
  Draws draws_;
};

/// The mean of an estimator in packets. Points stand in only where it would take more than `many` independent draws, which
/// hardly happens at a margin of 1e-3, and not where somebody listens to the draws. Throws what test_means does.
Finding check_mean_in_packets(const Trial& trial, const std::vector<Reference>& references, const Draws& draws,
                              double many = 1 << 27);

/// The mean in double with the packets as a control variate: E[double] = E[packet] + E[double - packet]. Packets draw some ten
/// times as fast, and from the same numbers the difference is next to nothing, so that few draws show its mean. Both parts
/// must be certified, each to a share of the margin, and each has half of alpha.
/// Source   Hammersley and Handscomb 1964, 5.5 (the control variate)
class PacketControlVariate {
 public:
  /// The scheme of the packets' mean, and its share of the margin. At a margin of 1e-4 the remaining 21 % is the least that
  /// the test accepts; where the difference varies, as paths in floats part from those in double, it is given more.
  struct Plan {
    static constexpr std::array shares{0.79, 0.6, 0.4};
    SamplingScheme scheme;
    double share = shares.front();
  };

  PacketControlVariate(const Trial& trial, const std::vector<Reference>& references, const PairedDraws& draws);

  /// The plan that takes the least time, if it takes less than double alone: not where the range is so wide that it alone
  /// says how many draws there must be, nor where these are so few that pilots cost more than they save. A pilot that is
  /// out of its range is left to double.
  std::optional<Plan> pays() const;

  /// Where the packets fail, the figures are theirs, as the difference is then not drawn, and the note says so. Throws what
  /// test_means does.
  Finding finding(const Plan& plan) const;

 private:
  std::optional<Plan> cheapest_plan() const;
  std::vector<Reference> difference_references(double share) const;
  bool fits(double share) const;
  Trial part(int i, Evidence& evidence) const;
  DrawBlock difference_draws(const std::string& purpose) const;
  void leave(const Evidence& packets, const Evidence& difference) const;

  Trial trial_;
  std::vector<Reference> references_;
  PairedDraws draws_;
  PacketMean packets_;
};

/// The mean of an estimator in double: with a packet control variate where that is faster, unless somebody listens, who is to
/// hear draws in double.
Finding check_mean_in_double(const Trial& trial, const std::vector<Reference>& references,
                             const PairedDraws& draws);

namespace detail {

/// What two parts say of the whole. A whole that is off by its margin has a part that is off by its share, so the less wealth of
/// the two is held against that; both parts are right where the whole is claimed to be, so the mean is held against the claim.
Wealth joint(const Wealth& a, const Wealth& b);

}  // namespace detail

}  // namespace fairlight
