#pragma once

#include <cpl_error.h>

#include <stdexcept>
#include <string>

namespace mrpt_mapconv::grid
{
/** Collects GDAL's errors of this thread while it lives, instead of letting GDAL print them.
 *
 * Needed because GDAL reports some of them late and through no return value: those of closing a
 * file (a full disk!) only reach the error handler.
 */
class GdalErrors
{
 public:
  GdalErrors() { CPLPushErrorHandlerEx(&GdalErrors::collect, this); }
  ~GdalErrors() { CPLPopErrorHandler(); }
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  bool any() const { return m_failed; }
  /** What the first of them says. */
  std::string first() const { return m_first.empty() ? "GDAL gives no reason" : m_first; }
  /** \exception std::runtime_error "cannot <action> '<path>': <first error>" */
  [[noreturn]] void raise(const std::string& action, const std::string& path) const
  {
    throw std::runtime_error("cannot " + action + " '" + path + "': " + first());
  }

 private:
  static void CPL_STDCALL collect(CPLErr level, CPLErrorNum, const char* message)
  {
    auto* self = static_cast<GdalErrors*>(CPLGetErrorHandlerUserData());
    if (level < CE_Failure || self->m_failed) return;
    self->m_failed = true;
    self->m_first = message;
    for (char& c : self->m_first)
      if (c == '\n') c = ' ';
  }

  bool m_failed = false;
  std::string m_first;
};

}  // namespace mrpt_mapconv::grid
