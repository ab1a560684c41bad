#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/evidence_sum.h>
#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// What a test saw, for people to look at and for accounts. Its own verdict does not ask it.
struct Evidence {
  /// A law's cells: row by row, how many draws fell in each and with which probability they should.
  struct Cells {
    int rows = 0;
    int columns = 0;
    std::vector<double> probabilities;
    std::vector<std::uint64_t> counts;
    double draws = 0;
  };

  /// The course of a betting test.
  class Course {
   public:
    struct Step {
      std::uint64_t draws;
      double mean;  ///< of the draws so far, in their own unit
      Wealth wealth;
    };

    explicit Course(const BettingTest& test);

    /// Where the test stands now. However long it is, a few hundred steps are kept.
    void add(const BettingTest& test);

    Sides sides() const { return sides_; }
    double refuting() const { return refuting_; }      ///< the log wealth that says `biased`
    double certifying() const { return certifying_; }  ///< the log wealth that says `certified`
    const std::vector<Step>& steps() const { return steps_; }

   private:
    Sides sides_;
    double refuting_, certifying_;
    std::vector<Step> steps_;
    std::uint64_t stride_ = 1;
    std::uint64_t seen_ = 0;
  };

  /// Of a claim whose parts are the cells of a grid, such as tiles of a picture: the bias of each in units of its margin, row by row.
  struct Tiles {
    int columns = 0;  ///< 0 where there are no tiles
    std::vector<double> biases;
  };

  std::vector<Cells> laws;
  std::vector<Course> means;  ///< one a channel; of a mean in parts, those of the first and then those of the next
  Tiles tiles;
  MarginGrid margin_grid;  ///< one a channel, for an evidence_sum of many runs

  /// Who wants the draws of a test of means themselves: told at its end (of a mean in parts, at the end of each) what was claimed of
  /// them, where they come from, and how many the test took. Those, and any beyond, may be drawn again while it listens, where a draw is a function of its number.
  std::function<void(const std::vector<Reference>& references, const DrawBlock& draw_block, std::uint64_t draws)>
      listener{};
};

}  // namespace fairlight
