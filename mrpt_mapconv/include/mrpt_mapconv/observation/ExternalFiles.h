#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::observation
{
/** The files outside its log from which an observation's points have yet to be read, as they lie in
 * MRPT's lazy-load directory. */
std::vector<std::string> externalFilesOf(const mrpt::obs::CObservation& obs);

/** Reads them into a scan. MRPT's own load() takes a file that is cut off for a whole one: the rest
 * of a range image is then whatever was in memory.
 * \exception std::runtime_error in one line naming the file: missing, cut off or damaged */
void loadExternal(mrpt::obs::CObservation3DRangeScan& scan);
/** The same; the cloud is MRPT's to change in a const observation. */
void loadExternal(const mrpt::obs::CObservationPointCloud& scan);

/** Sets MRPT's global lazy-load directory to that of a log: of NAME_Images, NAME_images,
 * NAME_IMAGES and Images beside NAME.rawlog the first that holds the scans' files, or else the
 * first that is there. Scans whose files are missing all the same are left out.
 * \param path of the log
 * \param log told how many were left out, and of the first one; may be null
 * \exception std::runtime_error in one line naming the log, a scan, its file and the folders that
 * were looked into, if of all the scans that have such files not one has them */
void findExternalFiles(std::vector<PosedObservation>& scans, const std::string& path,
                       const mrpt::system::COutputLogger* log);

}  // namespace mrpt_mapconv::observation
