#pragma once

#include <mrpt/poses/CPose2D.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <string>
#include <vector>

#include "support/TempDir.h"

namespace mrpt_mapconv::testing
{
/** A simulated run through the storey of flat.ini, in a folder of its own. */
class SlamLog
{
 public:
  SlamLog();

  /** Takes the 3D scans out of both rawlogs and of the simplemap. */
  void remove3D();

  /** A file in the folder; programs are run there. */
  std::string file(const std::string& name) const { return m_dir.path(name); }
  /** Runs a shell command in the folder; what it says goes to the file "said".
   * \return its exit status */
  int run(const std::string& command) const;
  /** What the command said; the end of it if that is long. */
  std::string said() const;

  mrpt::poses::CPose2D firstPose() const { return m_first; }  //!< true one, robot -> world
  mrpt::poses::CPose2D lastPose() const { return m_last; }    //!< likewise

  static constexpr double kFarOff = 1e9;
  /** How far pf-localization's last estimate in said() is from the true last pose [m]; kFarOff if
   * it made none. */
  double errorOfEstimate() const;

  /** Expects a map of the ground that is right; records its scores.
   * \param name of the scores in the test's report */
  void expectRight(const grid::Layer<float>& ground, const std::string& name) const;
  /** The same of the ground layer that our map has saved, called as the file is.
   * \param inStartFrame the map's frame is where the robot started, as in SLAM programs */
  void expectRight(const std::string& layersTif, bool inStartFrame) const;
  /** Expects a right map of what a robot of 1.5 m can hit, which our scan-shape map has saved;
   * records its scores. */
  void expectRightShape(const std::string& occupancyTif, bool inStartFrame) const;

 private:
  /** How a demand on a score is called, what it is, and what has been measured. */
  struct Demand
  {
    const char* what;
    double share, least;
    const char* measured;
  };

  static void expectAll(const std::string& name, const std::vector<Demand>& demands);
  grid::Layer<float> movedToWorld(const grid::Layer<float>& layer) const;

  TempDir m_dir;
  mrpt::poses::CPose2D m_first, m_last;
};

/** Whether all pixels of a picture are the same, as those of a map are that knows nothing. */
bool isUniform(const std::string& picture);

/** A file of the repository's config/, quoted for the shell. */
std::string configFile(const std::string& name);
/** What runs a program with the plugin, as `mapconv run` does; for the shell. */
std::string withPlugin();
}  // namespace mrpt_mapconv::testing
