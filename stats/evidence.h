#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/evidence_sum.h>
#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// What a test has observed, for reports and for the ledger. No verdict depends on it.
struct Evidence {
  /// The cells of a law test, row by row: the number of draws in each, and its probability.
  struct Cells {
    int rows = 0;
    int columns = 0;
    std::vector<double> probabilities;
    std::vector<std::uint64_t> counts;
    double draws = 0;
  };

  /// The wealth of a betting test as a function of the number of draws.
  class Course {
   public:
    struct Step {
      std::uint64_t draws;
      double mean;  ///< of the draws so far, in the draws' unit
      Wealth wealth;
    };

    explicit Course(const BettingTest& test);

    /// Records the present state of the test. When there are more than 512 steps, drops every
    /// second one.
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

  /// For a claim about a grid of cells, such as the tiles of a picture: the bias of each cell
  /// divided by its margin, row by row.
  struct Tiles {
    int columns = 0;  ///< 0 where there are no tiles
    std::vector<double> biases;
  };

  bool courses = true;  ///< whether tests of means record their courses, which takes time
  std::vector<Cells> laws;
  /// One per channel. A mean that is tested in parts lists the channels of the first part, then
  /// those of the next.
  std::vector<Course> means;
  Tiles tiles;
  MarginGrid margin_grid;  ///< one entry per channel, for the EvidenceSum of many runs

  /// Called when a test of means ends (once per part, for a mean that is tested in parts) with the
  /// references, the source of the draws and the number of draws that the test took. Where a draw
  /// is a function of its index, the callback may draw the same draws again, and further ones.
  std::function<void(const std::vector<Reference>& references, const DrawBlock& draw_block, std::uint64_t draws)>
      listener{};
};

}  // namespace fairlight
