#pragma once

#include <array>
#include <vector>

#include <fairlight/stats/verdict.h>
#include <fairlight/validation/checks/picture_cells.h>

namespace fairlight {

/// Whether two sets of pictures estimate the same image.
enum class Likeness {
  same,       ///< shown: every difference is inside its margin
  different,  ///< shown: some difference is not zero
  undecided,  ///< neither is shown
};

const char* name(Likeness likeness);

/// What a comparison shall show.
struct CompareOptions {
  double margin = 0.002;      ///< of each channel's mean and balanced mean, relative to it
  double tile_margin = 0.02;  ///< of tiles and border, relative to their mean, or the balanced mean if larger
  double alpha = 1e-3;        ///< the probability of calling equal images different, over all cells
  double beta = 0.01;         ///< the probability of calling images the same that differ by a margin
  double scale = 1;           ///< A is expected to be this many times B
  bool fit_scale = false;     ///< estimates the scale instead
};

/// One cell of one channel.
struct CellComparison {
  Likeness verdict = Likeness::undecided;
  double difference = 0;    ///< mean A - scale mean B, relative
  Interval interval{0, 0};  ///< of the difference; each end is wrong with probability at most beta
  double margin = 0;
  double p_value = 1;  ///< of no difference, before alpha is shared
  /// How many times as many renders would show `same`, if the images are equal.
  double renders_for_margin = 0;
};

struct Comparison {
  Likeness verdict = Likeness::undecided;
  double scale = 1;
  double scale_error = 0;                                 ///< the standard error of a fitted scale
  std::array<CellComparison, 3> whole, balanced, border;  ///< see BalancedMean
  std::vector<CellComparison> tiles;                      ///< [3 tile + channel]
  std::size_t worst = 0;                                  ///< the index in `tiles` of the smallest p-value
  double renders_for_margin = 0;                          ///< the most of all cells
  /// The smallest margin of the whole at which the verdict is `same` on these pictures, if tiles
  /// and border have the same multiple of it as in the options.
  double shown_margin = 0;
};

/// Compares the means of all cells by welch_log_p_value and welch_quantile. The mean of the whole,
/// its balanced mean, the border and the tiles have a quarter of alpha each, shared equally; beta
/// is half for the difference, half for what it is divided by. Guarantee: asymptotic. Throws
/// std::invalid_argument for levels or margins outside (0, 0.5), and for a fitted scale without a
/// spread of pictures.
/// Source   Jung, Hanika and Dachsbacher 2020. See docs/compare.md
Comparison compare_cells(const PictureCells& cells, const SideOfCells& a, const SideOfCells& b,
                         const CompareOptions& options);

}  // namespace fairlight
