/* Start-up and output of an emulated Cortex-M0, for the scene of the demo. A board of your own brings
 * all of this along; to it the library is one more archive. */
#include "../scene.h"

extern uint32_t stack_top, data_start, data_end, data_image, bss_start, bss_end;
int main(void);

/* Semihosting: a breakpoint at which the emulator acts. */
static void host(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

static void stop(void)
{
    host(0x18, (const void *)0x20026); /* SYS_EXIT: the application has ended */
    for (;;) {
    }
}

void reset(void)
{
    for (uint32_t *to = &data_start, *from = &data_image; to < &data_end;)
        *to++ = *from++;
    for (uint32_t *to = &bss_start; to < &bss_end;)
        *to++ = 0;
    main();
    stop();
}

__attribute__((section(".vectors"), used)) static const void *const vectors[] = {
    &stack_top, (const void *)reset, (const void *)stop, (const void *)stop,
};

static fixstep_world world;

static char digit(uint64_t hash, int place)
{
    return "0123456789abcdef"[hash >> (60 - 4 * place) & 15];
}

int main(void)
{
    char text[18] = "refused refused\n";
    uint64_t hash = 0;
    fixstep_status status = scene_build(&world);
    if (status == FIXSTEP_STATUS_OK)
        status = scene_run(&world, &hash);
    if (status == FIXSTEP_STATUS_OK) {
        for (int i = 0; i < 16; i++)
            text[i] = digit(hash, i);
        text[16] = '\n';
    }
    host(0x04, text); /* SYS_WRITE0 */
    return 0;
}
