#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <string>

namespace mrpt_mapconv::test
{
/** Whether a text holds a number or name as a word of its own: "0", but not in "100". */
inline bool holdsWord(const std::string& text, const std::string& word)
{
  const auto inWord = [](char c)
  { return std::isalnum(static_cast<unsigned char>(c)) || c == '.'; };
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    const auto end = at + word.size();
    if ((at == 0 || !inWord(text[at - 1])) && (end == text.size() || !inWord(text[end])))
      return true;
  }
  return false;
}

/** The message of the exception that an action ends with; empty, and a failure, without one. */
template <class Exception, class Action>
std::string thrownMessage(const Action& action)
{
  try
  {
    action();
  }
  catch (const Exception& e)
  {
    return e.what();
  }
  ADD_FAILURE() << "no exception";
  return {};
}

/** One line that names a parameter and its value. */
inline void expectNames(const std::string& message, const std::string& name,
                        const std::string& value)
{
  EXPECT_TRUE(holdsWord(message, name)) << name << " = " << value << ": " << message;
  EXPECT_TRUE(holdsWord(message, value)) << name << " = " << value << ": " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

}  // namespace mrpt_mapconv::test
