#pragma once

#include <mrpt/system/COutputLogger.h>

#include <array>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace mrpt_mapconv::observation
{
/** Where reading observations complains, remembering what it said.
 *
 * One object belongs to one map or one run of a program, so that a log with ten thousand scans of
 * an unknown lidar gives one warning and not ten thousand; objects that remember together belong to
 * copies of one map. The logger must outlive the object. Remembering is safe among threads.
 */
class SayOnceLog
{
 public:
  /** What is complained of, without the numbers that differ from one scan to the next. */
  struct Subject
  {
    std::string_view what;                        //!< e.g. "not finite"
    std::string_view className = {}, label = {};  //!< of the observation, if it matters
  };

  /** \param log may be null: warnings are dropped */
  explicit SayOnceLog(const mrpt::system::COutputLogger* log = nullptr)
      : m_log(log), m_said(std::make_shared<Said>())
  {
  }
  /** Goes on where another one is, and remembers together with it. */
  SayOnceLog(const mrpt::system::COutputLogger* log, const SayOnceLog& o)
      : m_log(log), m_said(o.m_said)
  {
  }
  /** From now on remembers together with another one; the logger stays. */
  void rememberWith(const SayOnceLog& o) { m_said = o.m_said; }

  void warn(const std::string& text)
  {
    if (m_log) m_log->logStr(mrpt::system::LVL_WARN, text);
  }
  /** Says something about a subject only once.
   * \param text makes what is said, and is called only then: what has been said costs no memory */
  template <class Text>
  void warnOnceOf(const Subject& subject, const Text& text)
  {
    if (isNew(subject)) warn(text() + " (said once)");
  }
  /** Says the same text only once. */
  void warnOnce(const std::string& text)
  {
    if (isNew({text})) warn(text);
  }
  /** True if it has not been asked of that subject before. */
  bool isNew(const Subject& subject)
  {
    const std::lock_guard<std::mutex> lock(m_said->mutex);
    if (m_said->subjects.count(subject) > 0) return false;
    m_said->subjects.insert(
        {std::string(subject.what), std::string(subject.className), std::string(subject.label)});
    return true;
  }

 private:
  using Key = std::array<std::string, 3>;
  /** Looks subjects up without making strings of them. */
  struct Less
  {
    using is_transparent = void;
    using Views = std::tuple<std::string_view, std::string_view, std::string_view>;

    static Views views(const Key& key) { return {key[0], key[1], key[2]}; }
    static Views views(const Subject& s) { return {s.what, s.className, s.label}; }
    template <class A, class B>
    bool operator()(const A& a, const B& b) const
    {
      return views(a) < views(b);
    }
  };
  struct Said
  {
    std::mutex mutex;
    std::set<Key, Less> subjects;
  };

  const mrpt::system::COutputLogger* m_log;
  std::shared_ptr<Said> m_said;
};

}  // namespace mrpt_mapconv::observation
