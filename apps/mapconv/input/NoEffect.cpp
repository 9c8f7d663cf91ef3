#include "input/NoEffect.h"

#include "output/Console.h"

namespace mapconv
{
void NoEffect::add(const std::vector<std::string>& names, const std::string& why)
{
  if (names.empty()) return;
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  m_text += (m_text.empty() ? "" : "; ") + list +
            (names.size() == 1 ? " has no effect: " : " have no effect: ") + why;
}

void NoEffect::addKeys(std::vector<std::string> keys, const std::string& iniFile,
                       const std::string& why)
{
  if (!keys.empty()) keys.back() += " of " + iniFile;
  add(keys, why);
}

void NoEffect::warn() const
{
  if (!m_text.empty()) printWarning(m_text);
}

}  // namespace mapconv
