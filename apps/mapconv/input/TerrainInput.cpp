#include "input/TerrainInput.h"

#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/observation/CloudScans.h>

#include <utility>

#include "input/EachScan.h"
#include "input/InputFile.h"

namespace mapconv
{
using namespace mrpt_mapconv;

TerrainInput::TerrainInput(const TerrainRequest& request, NoEffect& noEffect, Progress& progress)
    : m_name(shownName(request.file)), m_trajectory(request.trajectory)
{
  m_trajectory.times.maxGap = request.log.maxPoseGap;
  progress.stage("reading " + m_name);
  files::InputStream stream = openInput(request.file);
  if (!isOctree(stream) && cloud::isCloud(stream))
  {
    m_cloud = readSeenCloud(stream, request.geo, request.columns, request.trajectory, noEffect);
    m_reference = m_cloud->reference;
    m_description = describeCloud(m_cloud->cloud, m_cloud->cloud.size());
    return;
  }
  noteCloudOptions(request.trajectory, request.columns, request.geo, m_name, noEffect);
  m_log = read3DScans(std::move(stream), request.log, noEffect);
  m_reference = moveToOrigin(m_log->scans, m_name, request.geo, 0);
  m_description = m_log->description;
}

void TerrainInput::insertInto(TerrainBuilder& builder, Progress& progress) const
{
  if (m_cloud) return insertCloud(builder, progress);
  forEachScan(m_log->scans, m_name, progress, [&](const auto& scan) { builder.insert(scan); });
}

void TerrainInput::insertCloud(TerrainBuilder& builder, Progress& progress) const
{
  const observation::CloudScans scans(m_cloud->cloud, m_cloud->sensor, m_trajectory.times);
  checkCovered(*m_cloud, m_name, m_trajectory, scans.points(), scans.uncovered());
  forEachScan(scans.size(), m_name, progress,
              [&](std::size_t index) { builder.insert(scans.scan(index)); });
}

}  // namespace mapconv
