#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "BlockInput.h"
#include "CloudBuilder.h"
#include "Numbers.h"

namespace mrpt_mapconv::cloud
{
/** Which columns of a table (properties of PLY, fields of PCD, words of a line) are fields of a
 * cloud. Of columns that mean the same the first counts. */
class Columns
{
 public:
  /** Adds a column; what its name says decides. \param count values that it has a point; of
   * several only the first can be a field */
  void add(std::string_view name, NumberType type = NumberType::Float64, std::size_t count = 1);

  struct Used
  {
    Field field;
    NumberType type;
    std::size_t word;   //!< in a line, from 0 on
    std::size_t at;     //!< first byte in a binary point
    std::size_t bytes;  //!< of all values of the column in a point
  };
  const std::vector<Used>& used() const { return m_used; }
  FieldSet fields() const { return m_fields; }
  /** Names of the columns that are no field. */
  const std::vector<std::string>& others() const { return m_others; }
  std::size_t words() const { return m_words; }  //!< of a line
  std::size_t bytes() const { return m_bytes; }  //!< of a binary point

  bool hasCoordinates() const { return m_fields[0] && m_fields[1] && m_fields[2]; }
  /** \exception std::runtime_error naming the file, if it has not all of x, y and z */
  void requireCoordinates(const BlockInput& input) const;

 private:
  std::vector<Used> m_used;
  FieldSet m_fields;
  std::vector<std::string> m_others;
  std::size_t m_words = 0, m_bytes = 0;
};

/** A point as it stands in a binary file. */
Row binaryRow(const Columns& columns, const char* point, bool bigEndian = false);

/** Reads whole numbers and others as people and programs write them; "nan" and "inf", too.
 * \return false for all else */
bool readNumber(std::string_view word, double& number);

/** Splits a line at a character; at ' ' also at tabs, and as many as there are. */
void splitLine(std::string_view line, char separator, std::vector<std::string_view>& words);

/** A point as words of the last line that was read.
 * \exception std::runtime_error naming the file and the number of the line, if it has another
 * number of words, or one of them is no number */
Row textRow(const Columns& columns, const std::vector<std::string_view>& words,
            const BlockInput& input);

}  // namespace mrpt_mapconv::cloud
