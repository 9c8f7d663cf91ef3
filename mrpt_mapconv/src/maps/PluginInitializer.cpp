#include <mrpt/core/initializer.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/maps/CTerrainGridMap2D.h>

MRPT_INITIALIZER(registerMrptMapconvClasses)
{
  mrpt::rtti::registerClass(CLASS_ID(mrpt_mapconv::CFreeSpaceGridMap2D));
  mrpt::rtti::registerClass(CLASS_ID(mrpt_mapconv::CScanShapeGridMap2D));
  mrpt::rtti::registerClass(CLASS_ID(mrpt_mapconv::CTerrainGridMap2D));
}
