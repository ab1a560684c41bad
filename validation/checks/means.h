#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fairlight/stats/evidence.h>
#include <fairlight/validation/checks/draws.h>

/// How the mean of an estimator is tested, and from which numbers. The verdict is always that of
/// test_means.
namespace fairlight {

/// The number of points in a replicate. It is a power of two, so that Sobol' points are a net. It
/// is small, since the test needs about 5 range / (margin mean) replicates however little they
/// vary.
inline constexpr std::uint32_t points_a_replicate = 64;

/// The number of points in a replicate for these references: points_a_replicate, or a quarter of it
/// where a range is so wide that it alone sets the number of replicates.
std::uint32_t points_for(const std::vector<Reference>& references);

/// Tests a mean from independent numbers, with one reference for each channel.
Finding check_mean(const Trial& trial, const std::vector<Reference>& references, const Draws& draws);

template <class Real = double, class Draw>
Finding check_mean(const Trial& trial, const std::vector<Reference>& references,
                   const Draw& draw) requires(!std::is_same_v<Draw, Draws>) {
  const auto body = body_of<Real>([draw](std::type_identity<Real>, auto& source) { return draw(source); });
  return check_mean(trial, references, draws_of<Real>(body, references.size()));
}

/// Tests a mean over the points of a set. A draw of the test is the mean of a replicate of n
/// points.
template <PointSet Set>
Finding check_replicates(const Trial& trial, const std::vector<Reference>& references,
                         const std::shared_ptr<const Body<typename Set::Scalar>>& body, std::uint32_t n) {
  using Real = typename Set::Scalar;
  const std::vector<Reference> of_points = rounded_references<Real>(references);
  return test_means(trial, replicate_references(of_points, n),
                    replicate_draws<Real>(std::make_shared<PointNumbersOf<Set>>(), body,
                                          StreamKey(trial.seed, trial.claim), of_points, n));
}

/// The numbers of a draw: independent (points = 1), or the draw is the mean of a replicate of
/// `points` Sobol' points.
struct SamplingScheme {
  std::uint32_t points = 1;
  bool is_independent() const { return points == 1; }
};

/// The mean of draws in packets, from independent numbers or over Sobol' points. The mean is the
/// same, but over points the draws vary less.
/// Source   Owen 1995 (the points)
class PacketMean {
 public:
  /// The sizes of replicates to choose from. The smaller is for ranges so wide that they alone set
  /// the number of replicates.
  static constexpr std::array<std::uint32_t, 2> replicate_sizes{points_a_replicate / 4, points_a_replicate};

  PacketMean(const Trial& trial, const std::vector<Reference>& references, const Draws& draws);

  /// The references of the draws of a scheme, where the mean gets this share of the margin.
  std::vector<Reference> references(const SamplingScheme& scheme, double share) const;

  struct Choice {
    SamplingScheme scheme;
    double cost;  ///< in units of the time of a packet from independent numbers
  };

  /// Estimates from a few pilot draws how many draws each scheme needs.
  class Pilots {
   public:
    /// The cost from independent numbers, where the mean gets this share of the margin. Throws
    /// BadDraw for a draw outside the range of its reference.
    Choice independent(double share) const;
    /// The fastest scheme.
    Choice cheapest(double share) const;
    /// Adds the schemes with points. Two packets over points are taken to cost as much as three
    /// from independent numbers.
    void add_points();

   private:
    friend PacketMean;
    struct Seen {
      SamplingScheme scheme;
      double packets;  ///< the cost of as many draws as a packet has lanes
      std::vector<std::vector<double>> channels;
    };
    explicit Pilots(const PacketMean& mean);
    void add(const SamplingScheme& scheme, double packets, std::size_t draws);
    Choice choice(const Seen& seen, double share) const;

    const PacketMean& mean_;
    std::vector<Seen> seen_;
  };

  Pilots pilots() const& { return Pilots(*this); }

  /// The fastest scheme where the mean gets the whole margin. It is over points only where
  /// independent numbers would take more than `many` draws. Throws BadDraw where a pilot draw is out
  /// of its range.
  SamplingScheme cheapest(double many) const;

  /// The finding of test_means for each channel; throws what that throws. Counts single draws, not
  /// replicates. Levels are those of the given trial, random numbers those of this mean.
  std::vector<Finding> test_each(const Trial& trial, const SamplingScheme& scheme, double share = 1) const;

 private:
  DrawBlock draws(const SamplingScheme& scheme, const std::string& purpose) const;

  Trial trial_;
  std::vector<Reference> references_;
  Draws draws_;
};

/// Tests the mean of an estimator in packets. It uses points only where it would take more than
/// `many` independent draws, which hardly happens at a margin of 1e-3, and never where the trial
/// has an Evidence::listener. Throws what test_means does.
Finding check_mean_in_packets(const Trial& trial, const std::vector<Reference>& references, const Draws& draws,
                              double many = 1 << 27);

/// Tests a mean in double with packets as a control variate. Packets draw some ten times as fast,
/// and from the same numbers the difference is almost zero, so it needs few draws. Both parts must
/// be certified, each to a share of the margin and at half of alpha.
/// Formula  E[double] = E[packet] + E[double - packet]
/// Source   Hammersley and Handscomb 1964, 5.5 (the control variate)
class PacketControlVariate {
 public:
  /// The scheme of the packets' mean, and its share of the margin. The difference gets the rest. At
  /// a margin of 1e-4 that is at least 21 %, or the test refuses the rounding of floats. It gets
  /// more where the difference varies, as where paths in floats diverge from those in double.
  struct Plan {
    static constexpr std::array shares{0.79, 0.6, 0.4};
    SamplingScheme scheme;
    double share = shares.front();
  };

  PacketControlVariate(const Trial& trial, const std::vector<Reference>& references, const PairedDraws& draws);

  /// The fastest plan, or none if draws in double alone are faster. There is none where the range
  /// is so wide that it alone sets the number of draws, or where these are so few that the pilot
  /// costs more than it saves. Throws BadDraw where a pilot draw is out of its range.
  std::optional<Plan> pays() const;

  /// The finding of both parts. If the packets are not certified, it does not test the difference:
  /// the figures are those of the packets, and the note says so. Throws what test_means does.
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

/// Tests the mean of an estimator in double: with a packet control variate where that is faster. A
/// trial with an Evidence::listener always draws in double.
Finding check_mean_in_double(const Trial& trial, const std::vector<Reference>& references,
                             const PairedDraws& draws);

namespace detail {

/// The wealth of the sum of two parts. If the sum is off by its margin, one part is off by its
/// share, so the smaller of their wealths counts against that. If the reference is right, both
/// parts are, so the mean of their wealths counts against it.
Wealth joint(const Wealth& a, const Wealth& b);

}  // namespace detail

}  // namespace fairlight
