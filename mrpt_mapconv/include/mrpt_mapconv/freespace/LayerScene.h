#pragma once

#include <mrpt_mapconv/freespace/FreeSpaceScene.h>  // for command/Params.cpp, until it names that
