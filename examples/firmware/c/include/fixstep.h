/* Moves up to 32 points under gravity and linear drag, in fixed point, without a heap.
 *
 * Made by `UPDATE=1 cargo test --test header` from the comments of src/. Numbers are int32_t in units
 * of 1/65536, from -32768 to just below 32768; lengths in m, times in s, masses in kg. Equal calls
 * give equal bits on every target. A call that refuses changes nothing. None allocates, waits or locks:
 * a world that an interrupt uses too needs the usual care.
 */

#ifndef FIXSTEP_H
#define FIXSTEP_H

#include <stdint.h>

/* A number as a constant: FIXSTEP(-9.81). Folded by the compiler, also in a static initialiser. For
 * a number that is known at run time only it would link software doubles. */
#define FIXSTEP(x) ((int32_t)((x) * 65536.0 + ((x) < 0 ? -0.5 : 0.5)))

/* A whole number from -32768 to 32767. */
static inline int32_t fixstep_int(int16_t whole)
{
    return (int32_t)whole * 65536;
}

/* The nearest whole number; halves go up. */
static inline int32_t fixstep_round(int32_t number)
{
    return (number >> 16) + ((number >> 15) & 1);
}


// How many points a world holds.
#define FIXSTEP_CAPACITY 32

// Steps a second, exactly: each is 1/64 s, which cores without a long multiply take as a shift.
#define FIXSTEP_HZ 64

// Words of a world.
#define FIXSTEP_WORDS 111

// What a call answers. All but FIXSTEP_STATUS_OK have changed nothing.
typedef enum {
  // Done.
  FIXSTEP_STATUS_OK = 0,
  // A pointer is null.
  FIXSTEP_STATUS_NULL = 1,
  // The world was not given to fixstep_init.
  FIXSTEP_STATUS_NOT_INITIALISED = 2,
  // A mass or drag that the library cannot hold: zero, negative, too small or too large.
  FIXSTEP_STATUS_BAD_VALUE = 3,
  // No room for another point.
  FIXSTEP_STATUS_FULL = 4,
  // No point of that id, or no more.
  FIXSTEP_STATUS_STALE = 5,
} fixstep_status;

// The memory of a world: a static, or `fixstep_world w = {0};`. What is inside is the library's;
// a copy is a snapshot. Every call but fixstep_init refuses one that is all zero; memory that was never set
// must not be handed to another.
typedef struct {
  // Not to be touched.
  uint64_t opaque[FIXSTEP_WORDS];
} fixstep_world;

// Where a point is, m, and how it moves, m/s.
typedef struct {
  int32_t x;
  int32_t y;
  int32_t vx;
  int32_t vy;
} fixstep_body;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Makes an empty world, also of one that was used before.
//
// `gravity_x` and `gravity_y` are an acceleration, m/s^2; `drag` is the force at 1 m/s, kg/s, not
// negative. A point is stable while drag < 2 FIXSTEP_HZ mass.
fixstep_status fixstep_init(fixstep_world *world,
                            int32_t gravity_x,
                            int32_t gravity_y,
                            int32_t drag);

// Adds a point of `mass`, from 0.5 g, and writes its id to `id`. Ids are never given twice.
fixstep_status fixstep_add(fixstep_world *world,
                           const fixstep_body *body,
                           int32_t mass,
                           uint32_t *id);

// Makes one step.
fixstep_status fixstep_step(fixstep_world *world);

// Writes where the point of that id is to `body`.
fixstep_status fixstep_get(const fixstep_world *world, uint32_t id, fixstep_body *body);

// Puts the point of that id elsewhere, with another velocity: for walls and controls of your own.
fixstep_status fixstep_set(fixstep_world *world, uint32_t id, const fixstep_body *body);

// Takes the point of that id out; the others keep their ids.
fixstep_status fixstep_remove(fixstep_world *world, uint32_t id);

// Writes a hash of the step count, the ids and the exact bits of the points to `hash`.
fixstep_status fixstep_hash(const fixstep_world *world, uint64_t *hash);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* FIXSTEP_H */
