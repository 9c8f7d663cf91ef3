#pragma once

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CSerializable.h>

#include <string>
#include <string_view>

namespace mrpt_mapconv::files
{
/** A gzipped file of serialized MRPT objects that is written one by one. */
class ObjectStream
{
 public:
  /** \exception std::runtime_error naming the file and the system's reason, as all of this class */
  explicit ObjectStream(const std::string& path);

  void write(const mrpt::serialization::CSerializable& object);
  void write(std::string_view bytes);
  /** Ends the file and makes sure that all of it has arrived. */
  void finish();

 private:
  std::string m_path;
  mrpt::io::CFileGZOutputStream m_file;
};

/** An object as MRPT stores it. */
std::string serialized(const mrpt::serialization::CSerializable& object);

/** A CSimpleMap that is written key frame by key frame, since it can be larger than the memory. */
class SimpleMapStream
{
 public:
  /** \param keyFrames how many will be written */
  SimpleMapStream(const std::string& path, std::uint32_t keyFrames);
  /** \param pose a CPose3DPDF \param frame a CSensoryFrame */
  void write(const mrpt::serialization::CSerializable& pose,
             const mrpt::serialization::CSerializable& frame);
  void finish();

 private:
  ObjectStream m_stream;
  std::uint32_t m_missing;
  std::string m_end;
};

}  // namespace mrpt_mapconv::files
