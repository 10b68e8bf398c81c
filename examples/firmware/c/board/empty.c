/* The same image without the library: what is weighed against. */
#include "../scene.h"

fixstep_status scene_build(fixstep_world *world)
{
    (void)world;
    return FIXSTEP_STATUS_OK;
}

fixstep_status scene_run(fixstep_world *world, uint64_t *hash)
{
    *hash = world->opaque[0];
    return FIXSTEP_STATUS_OK;
}
