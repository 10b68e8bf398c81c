/* The scene of the demo, for a host and for a board. */
#ifndef SCENE_H
#define SCENE_H

#include "fixstep.h"

#define SCENE_STEPS 600

/* 32 points with different masses, thrown side by side. */
fixstep_status scene_build(fixstep_world *world);

/* SCENE_STEPS steps, and the hash of what they lead to. */
fixstep_status scene_run(fixstep_world *world, uint64_t *hash);

#endif
