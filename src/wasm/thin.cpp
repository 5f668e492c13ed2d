#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "social_crowd/episode.h"

using namespace crowd;
int main(int argc, char** argv) {
  try {
    const library::QTable table = library::QTable::read(argv[1]);
    const int ticks = atoi(argv[3]);
    library::Learner learner(table);
    const library::Scenario scenario = library::Scenario::load(argv[2]);
    library::Episode episode(scenario, table.vision(), 1, 0);
    library::AgentArrays a;
    while (episode.tick() < (unsigned)ticks && episode.walk(learner)) {
      episode.agents(a);
      for (size_t i = 0; i < a.id.size(); ++i) {
        uint64_t b[3];
        memcpy(b, &a.position[2 * i], 16);
        memcpy(b + 2, &a.heading[i], 8);
        printf("%u %u %d %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", (unsigned)episode.tick(), (unsigned)a.id[i], a.status[i], b[0], b[1], b[2]);
      }
    }
  } catch (const std::exception& e) { printf("ERROR %s\n", e.what()); return 1; }
}
