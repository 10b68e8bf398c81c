/* Every refusal, from C, and that it changes nothing. Exit code: the line that failed. */
#include <stddef.h>
#include <string.h>

#include "fixstep.h"

#define EXPECT(call, answer) \
    do { \
        if ((call) != (answer)) \
            return __LINE__; \
    } while (0)
#define OK FIXSTEP_STATUS_OK
#define BAD FIXSTEP_STATUS_BAD_VALUE
#define NONE FIXSTEP_STATUS_NOT_INITIALISED

static fixstep_world world, before, zero;
static const fixstep_body ball = {FIXSTEP(1.5), FIXSTEP(-2), 3, -4};
static int unchanged(void)
{
    return memcmp(&world, &before, sizeof world) == 0;
}

static int not_initialised(void)
{
    fixstep_body body;
    uint32_t id;
    uint64_t hash;
    EXPECT(fixstep_add(&zero, &ball, FIXSTEP(1), &id), NONE);
    EXPECT(fixstep_step(&zero), NONE);
    EXPECT(fixstep_get(&zero, 0, &body), NONE);
    EXPECT(fixstep_set(&zero, 0, &ball), NONE);
    EXPECT(fixstep_remove(&zero, 0), NONE);
    EXPECT(fixstep_hash(&zero, &hash), NONE);
    memset(&before, 0xa5, sizeof before);
    EXPECT(fixstep_step(&before), NONE);
    return 0;
}

static int null(void)
{
    const fixstep_status expected = FIXSTEP_STATUS_NULL;
    fixstep_body body;
    uint32_t id;
    uint64_t hash;
    EXPECT(fixstep_init(NULL, 0, 0, 0), expected);
    EXPECT(fixstep_add(NULL, &ball, FIXSTEP(1), &id), expected);
    EXPECT(fixstep_add(&world, NULL, FIXSTEP(1), &id), expected);
    EXPECT(fixstep_add(&world, &ball, FIXSTEP(1), NULL), expected);
    EXPECT(fixstep_step(NULL), expected);
    EXPECT(fixstep_get(NULL, 0, &body), expected);
    EXPECT(fixstep_get(&world, 0, NULL), expected);
    EXPECT(fixstep_set(NULL, 0, &ball), expected);
    EXPECT(fixstep_set(&world, 0, NULL), expected);
    EXPECT(fixstep_remove(NULL, 0), expected);
    EXPECT(fixstep_hash(NULL, &hash), expected);
    EXPECT(fixstep_hash(&world, NULL), expected);
    return 0;
}

static int values(void)
{
    uint32_t id = 77;
    EXPECT(fixstep_init(&world, 0, 0, -1), BAD);
    EXPECT(fixstep_init(&world, 0, 0, INT32_MIN), BAD);
    EXPECT(fixstep_add(&world, &ball, 0, &id), BAD);
    EXPECT(fixstep_add(&world, &ball, -1, &id), BAD);
    EXPECT(fixstep_add(&world, &ball, 1, &id), BAD); /* 15 mg */
    EXPECT(id, 77);
    return 0;
}

/* Full after 32, stale before an id is given and after its point is gone. */
static int ids(void)
{
    fixstep_body body = {0, 0, 0, 0};
    uint32_t id = 77;
    EXPECT(fixstep_get(&world, 0, &body), FIXSTEP_STATUS_STALE);
    for (uint32_t i = 0; i < FIXSTEP_CAPACITY; i++) {
        EXPECT(fixstep_add(&world, &ball, FIXSTEP(1), &id), OK);
        EXPECT(id, i);
    }
    EXPECT(fixstep_add(&world, &ball, FIXSTEP(1), &id), FIXSTEP_STATUS_FULL);
    EXPECT(id, FIXSTEP_CAPACITY - 1);
    EXPECT(fixstep_remove(&world, 7), OK);
    before = world;
    EXPECT(fixstep_remove(&world, 7), FIXSTEP_STATUS_STALE);
    EXPECT(fixstep_set(&world, 7, &ball), FIXSTEP_STATUS_STALE);
    EXPECT(fixstep_get(&world, 7, &body), FIXSTEP_STATUS_STALE);
    EXPECT(fixstep_get(&world, UINT32_MAX, &body), FIXSTEP_STATUS_STALE);
    EXPECT(unchanged(), 1);
    EXPECT(fixstep_add(&world, &ball, FIXSTEP(1), &id), OK);
    EXPECT(id, FIXSTEP_CAPACITY);
    return 0;
}

/* What was set is there, others do not move, and a copy goes its own way to the same end. */
static int state(void)
{
    fixstep_body body;
    uint64_t here, there;
    const fixstep_body other = {INT32_MIN, INT32_MAX, 0, 65536};
    EXPECT(fixstep_set(&world, 8, &other), OK);
    EXPECT(fixstep_get(&world, 8, &body), OK);
    EXPECT(memcmp(&body, &other, sizeof body), 0);
    EXPECT(fixstep_get(&world, 9, &body), OK);
    EXPECT(memcmp(&body, &ball, sizeof body), 0);
    before = world;
    EXPECT(fixstep_step(&world), OK);
    EXPECT(fixstep_hash(&world, &here), OK);
    EXPECT(fixstep_hash(&before, &there), OK);
    EXPECT(here == there, 0);
    EXPECT(fixstep_step(&before), OK);
    EXPECT(fixstep_hash(&before, &there), OK);
    EXPECT(here == there, 1);
    return 0;
}

static int numbers(void)
{
    EXPECT(FIXSTEP(-9.81), -642908); /* -642908.16 */
    EXPECT(FIXSTEP(0.1), 6554); /* 6553.6 */
    EXPECT(fixstep_int(-32768), INT32_MIN);
    EXPECT(fixstep_round(INT32_MIN), -32768);
    EXPECT(fixstep_round(INT32_MAX), 32768);
    EXPECT(fixstep_round(FIXSTEP(2.5)), 3);
    EXPECT(fixstep_round(FIXSTEP(-2.5)), -2);
    EXPECT(fixstep_round(FIXSTEP(-2.6)), -3);
    EXPECT(fixstep_round(FIXSTEP(0.4)), 0);
    return 0;
}

int main(void)
{
    int line = not_initialised();
    if (line == 0 && fixstep_init(&world, 0, FIXSTEP(-9.81), FIXSTEP(0.1)) != OK)
        line = __LINE__;
    before = world;
    if (line == 0)
        line = null();
    if (line == 0)
        line = values();
    if (line == 0 && !unchanged())
        line = __LINE__;
    if (line == 0)
        line = ids();
    if (line == 0)
        line = state();
    if (line == 0)
        line = numbers();
    return line;
}
