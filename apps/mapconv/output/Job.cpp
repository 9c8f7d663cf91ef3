#include "output/Job.h"

namespace mapconv
{
using mrpt_mapconv::files::AtomicFile;
using mrpt_mapconv::files::OutputDir;

void Job::checkOutput(const std::string& dir) const { static_cast<void>(OutputDir(dir)); }

void Job::write(const std::string& dir, const std::function<void(OutputDir&)>& fill,
                AtomicFile* beside)
{
  stage("write", "writing to " + dir,
        [&]
        {
          OutputDir out(dir);
          Interruptible::Outputs staged{&out};
          if (beside && beside->folder()) staged.push_back(beside->folder());
          const auto watch = m_interruptible.watch(staged);
          fill(out);
          m_interruptible.commit(
              [&]
              {
                out.commit();
                if (beside) beside->commit();
              });
        });
}

void Job::print(const std::string& result)
{
  m_progress.reset();  // it must not draw over the result
  m_output.print(result);
}

}  // namespace mapconv
