/* Runs the scene on a host and prints its hash. */
#include <inttypes.h>
#include <stdio.h>

#include "scene.h"

static fixstep_world world;

int main(void)
{
    uint64_t hash;
    fixstep_status status = scene_build(&world);
    if (status == FIXSTEP_STATUS_OK)
        status = scene_run(&world, &hash);
    if (status != FIXSTEP_STATUS_OK) {
        fprintf(stderr, "refused: status %d\n", status);
        return 1;
    }
    printf("%016" PRIx64 "\n", hash);
    return 0;
}
