#pragma once

#include <mrpt_mapconv/files/AtomicFile.h>
#include <mrpt_mapconv/files/OutputDir.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/Console.h"
#include "output/Interruptible.h"
#include "output/Progress.h"

namespace mapconv
{
/** The stages of a job and how long they took [s], in their order. */
using Seconds = std::vector<std::pair<std::string, double>>;

/** What every command does that writes a folder: it shows how far it is, times its stages, leaves
 * all files or none, also when it is interrupted, and has stdout for its result alone.
 *
 * \code
 * Job job;
 * job.checkOutput(dir);
 * const InputMap input = job.stage("load", [&] { return InputMap(request, job.progress()); });
 * const auto layer = job.stage("convert", "converting", [&] { return layerOf(input); });
 * job.write(dir, [&](files::OutputDir& out) { writeGeoTiff(out.path("layer.tif"), layer); });
 * job.print(summary(layer, job.seconds()));
 * \endcode
 *
 * To be made before any other thread, as Interruptible. */
class Job
{
 public:
  /** Says now, not after minutes of work, if nothing can be written there; leaves no folder behind.
   * \exception std::runtime_error naming the path and the reason */
  void checkOutput(const std::string& dir) const;

  Progress& progress() { return *m_progress; }

  /** Does a stage and times it. \param name of its time \return what `work` returns */
  template <class Work>
  auto stage(const std::string& name, const Work& work)
  {
    const Timed timed(m_seconds, name);  // stops after the result is made, which may not be movable
    return work();
  }
  /** The same. \param shown how the progress calls it */
  template <class Work>
  auto stage(const std::string& name, const std::string& shown, const Work& work)
  {
    m_progress->stage(shown);
    return stage(name, work);
  }

  /** The stage "write": fills a folder, in which the files then appear all or none.
   * \param beside a file elsewhere that `fill` writes, too, and that appears behind them; null:
   * none \exception std::exception if the folder or a file cannot be written; whatever `fill`
   * throws */
  void write(const std::string& dir,
             const std::function<void(mrpt_mapconv::files::OutputDir&)>& fill,
             mrpt_mapconv::files::AtomicFile* beside = nullptr);

  const Seconds& seconds() const { return m_seconds; }

  /** Ends the progress and prints the result on stdout.
   * \exception std::runtime_error with the system's reason, e.g. on a full disk */
  void print(const std::string& result);

 private:
  /** Notes at its end how long it has lived. */
  class Timed
  {
   public:
    Timed(Seconds& seconds, const std::string& name) : m_seconds(seconds), m_index(seconds.size())
    {
      m_seconds.emplace_back(name, 0);
    }
    ~Timed() { m_seconds[m_index].second = m_watch.lap(); }
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;

   private:
    Seconds& m_seconds;
    const std::size_t m_index;
    Stopwatch m_watch;
  };

  // In this order: the signals first, before there are threads; the progress last, which draws on
  // the messages that the output has taken over.
  Interruptible m_interruptible;
  ResultOutput m_output;
  std::optional<Progress> m_progress{std::in_place};
  Seconds m_seconds;
};

}  // namespace mapconv
