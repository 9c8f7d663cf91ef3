#include "output/Job.h"

namespace mapconv
{
using mrpt_mapconv::files::OutputDir;

void Job::checkOutput(const std::string& dir) const { static_cast<void>(OutputDir(dir)); }

void Job::write(const std::string& dir, const std::function<void(OutputDir&)>& fill)
{
  stage("write", "writing to " + dir,
        [&]
        {
          OutputDir out(dir);
          const auto watch = m_interruptible.watch(out);
          fill(out);
          m_interruptible.commit();
        });
}

void Job::print(const std::string& result)
{
  m_progress.reset();  // it must not draw over the result
  m_output.print(result);
}

}  // namespace mapconv
