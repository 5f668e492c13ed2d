#pragma once

#include <vector>

/// Bearings on both sides of the limits of sectors, and the sectors that contain them.
namespace crowd::sector_cases {

struct SectorCase {
  double degrees;
  int sector;
};

/// Eight even sectors; sector 0 is centred straight ahead.
inline const std::vector<SectorCase> EVEN = {{0.0, 0},    {22.4, 0},   {22.6, 1},  {67.4, 1},  {67.6, 2},   {112.4, 2},
                                             {112.6, 3},  {157.4, 3},  {157.6, 4}, {180.0, 4}, {-157.6, 4}, {-157.4, 5},
                                             {-112.6, 5}, {-112.4, 6}, {-67.6, 6}, {-67.4, 7}, {-22.6, 7},  {-22.4, 0}};

/// The uneven sectors of the thesis, figure 3.6: 15, 45, 90 and 180 degrees to either side.
inline const std::vector<SectorCase> UNEVEN = {{0.0, 0},   {14.9, 0},  {15.1, 1},  {44.9, 1},  {45.1, 2},  {89.9, 2},
                                               {90.1, 3},  {179.9, 3}, {-0.1, 4},  {-14.9, 4}, {-15.1, 5}, {-44.9, 5},
                                               {-45.1, 6}, {-89.9, 6}, {-90.1, 7}, {-179.9, 7}};

}  // namespace crowd::sector_cases
