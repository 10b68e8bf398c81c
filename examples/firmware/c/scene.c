#include "scene.h"

fixstep_status scene_build(fixstep_world *world)
{
    fixstep_status status = fixstep_init(world, 0, FIXSTEP(-9.81), FIXSTEP(0.1));
    for (int16_t i = 0; i < FIXSTEP_CAPACITY && status == FIXSTEP_STATUS_OK; i++) {
        fixstep_body body = {
            .x = fixstep_int((int16_t)(i - 16)),
            .y = fixstep_int((int16_t)(60 + i)),
            .vx = fixstep_int((int16_t)(16 - i)),
            .vy = 0,
        };
        int32_t mass = FIXSTEP(0.5) + i * FIXSTEP(0.25);
        uint32_t id;
        status = fixstep_add(world, &body, mass, &id);
    }
    return status;
}

fixstep_status scene_run(fixstep_world *world, uint64_t *hash)
{
    for (int i = 0; i < SCENE_STEPS; i++) {
        fixstep_status status = fixstep_step(world);
        if (status != FIXSTEP_STATUS_OK)
            return status;
    }
    return fixstep_hash(world, hash);
}
