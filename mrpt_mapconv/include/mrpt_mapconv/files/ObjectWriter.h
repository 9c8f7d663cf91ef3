#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <string>

namespace mrpt_mapconv::files
{
/** Writes an MRPT object as MRPT's programs read it: serialized and gzipped.
 *
 * Compressed in memory and written by ourselves: MRPT's file streams hide errors of closing, and
 * its in-memory compression goes through a temporary file that two processes can share by accident.
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writeObject(const std::string& path, const mrpt::serialization::CSerializable& object);

}  // namespace mrpt_mapconv::files
