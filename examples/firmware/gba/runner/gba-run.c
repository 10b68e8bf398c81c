/* Runs a Game Boy Advance image without a window, by libmgba. The same image and keys give the same
 * lines and the same pictures, to the byte.
 *
 *     cc -O2 -o gba-run gba-run.c -lmgba -lpng
 *
 * Frames are counted from 1. A key script is a file of lines `FRAME KEYS`: from that frame on these
 * keys are down, and no others. */
#include <mgba/flags.h>

#include <mgba/core/config.h>
#include <mgba/core/core.h>
#include <mgba/core/log.h>
#include <png.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char USAGE[] =
	"usage: gba-run [-f FRAMES] [-k KEYS] [-s FRAME:FILE.png]... [-z ZOOM] IMAGE\n"
	"\n"
	"  IMAGE             a .gba file or an ELF; lines of its debug log go to standard output\n"
	"  -f FRAMES         give up after so many frames (600000, near three hours)\n"
	"  -k KEYS           press keys: a file of lines such as `120 A+RIGHT`, `125 -`, `# a comment`\n"
	"                    A B SELECT START RIGHT LEFT UP DOWN R L, joined by +; - for none\n"
	"  -s FRAME:FILE     write the screen as it is at the end of that frame; may be repeated\n"
	"  -z ZOOM           pixels of the picture for one of the screen, in each direction (1)\n"
	"\n"
	"Ends at a line `EXIT n` with n, or after the last picture with 0. Otherwise:\n"
	"  2  arguments, or a file that cannot be read or written\n"
	"  3  the emulator has found an error, such as a jump out of memory\n"
	"  4  no line `EXIT n` in FRAMES frames\n";

enum { WRONG_CALL = 2, CRASHED = 3, NO_END = 4, MOST = 256 };

struct Press { long frame; unsigned keys; };
struct Shot { long frame; const char* file; };

static struct Press presses[MOST];
static struct Shot shots[MOST];
static int press_count, shot_count;
static int end = -1; /* what the image or the emulator ended with */

static void stop(const char* what, const char* which) {
	fprintf(stderr, "gba-run: %s%s%s\n", what, which ? ": " : "", which ? which : "");
	exit(WRONG_CALL);
}

/* A line of the image's log, or what the emulator has to say. */
static void on_log(struct mLogger* logger, int category, enum mLogLevel level, const char* format,
		va_list arguments) {
	(void) logger;
	char line[1024];
	vsnprintf(line, sizeof line, format, arguments);
	const char* id = mLogCategoryId(category);
	if (end >= 0) return;
	if (id && !strcmp(id, "gba.debug")) {
		puts(line);
		sscanf(line, "EXIT %d", &end);
	} else if (level & (mLOG_FATAL | mLOG_ERROR | mLOG_GAME_ERROR)) {
		fprintf(stderr, "gba-run: %s\n", line);
		end = CRASHED;
	}
}

static unsigned keys_of(char* names) {
	static const char* const NAMES[] =
		{ "A", "B", "SELECT", "START", "RIGHT", "LEFT", "UP", "DOWN", "R", "L" };
	unsigned keys = 0;
	for (char* name = strtok(names, "+"); name; name = strtok(NULL, "+")) {
		unsigned i = 0;
		while (i < 10 && strcmp(name, NAMES[i])) i++;
		if (i < 10) keys |= 1u << i;
		else if (strcmp(name, "-")) stop("no such key", name);
	}
	return keys;
}

static void read_keys(const char* path) {
	FILE* file = fopen(path, "r");
	if (!file) stop("cannot read", path);
	char line[128], names[64];
	while (fgets(line, sizeof line, file)) {
		line[strcspn(line, "#\r\n")] = 0;
		if (!line[strspn(line, " \t")]) continue;
		struct Press press;
		if (sscanf(line, "%ld %63s", &press.frame, names) != 2 || press.frame < 1
			|| (press_count && press.frame <= presses[press_count - 1].frame))
			stop("not `FRAME KEYS` with rising frames", line);
		if (press_count == MOST) stop("too many lines", path);
		press.keys = keys_of(names);
		presses[press_count++] = press;
	}
	fclose(file);
}

static void add_shot(char* argument) {
	char* colon = strchr(argument, ':');
	struct Shot shot = { strtol(argument, NULL, 10), colon ? colon + 1 : "" };
	if (!colon || shot.frame < 1 || !*shot.file) stop("not FRAME:FILE", argument);
	if (shot_count == MOST) stop("too many pictures", NULL);
	shots[shot_count++] = shot;
}

static void write_png(const char* path, const color_t* screen, unsigned width, unsigned height,
		unsigned zoom) {
	FILE* file = fopen(path, "wb");
	png_bytep row = malloc((size_t) width * zoom * 3);
	png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
	png_infop info = png ? png_create_info_struct(png) : NULL;
	if (!file || !row || !info || setjmp(png_jmpbuf(png))) stop("cannot write", path);
	png_init_io(png, file);
	png_set_IHDR(png, info, width * zoom, height * zoom, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
		PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
	png_write_info(png, info);
	for (unsigned y = 0; y < height; y++) {
		for (unsigned x = 0; x < width * zoom; x++) {
			color_t color = screen[y * width + x / zoom]; /* red lowest */
			for (int part = 0; part < 3; part++) row[3 * x + part] = color >> 8 * part;
		}
		for (unsigned i = 0; i < zoom; i++) png_write_row(png, row);
	}
	png_write_end(png, NULL);
	png_destroy_write_struct(&png, &info);
	free(row);
	if (fclose(file)) stop("cannot write", path);
}

int main(int count, char** words) {
	long frames = 600000, last = 0;
	unsigned zoom = 1, width, height;
	const char* image = NULL;
	for (int i = 1; i < count; i++) {
		char option = words[i][0] == '-' && words[i][1] && !words[i][2] ? words[i][1] : 0;
		if (!option && words[i][0] != '-' && !image) {
			image = words[i];
			continue;
		}
		if (!option || !strchr("fksz", option) || i + 1 == count) {
			fputs(USAGE, stderr);
			return WRONG_CALL;
		}
		char* value = words[++i];
		if (option == 'k') read_keys(value);
		if (option == 's') add_shot(value);
		if (option == 'f' && (frames = strtol(value, NULL, 10)) < 1) stop("no frames", value);
		if (option == 'z' && ((zoom = strtoul(value, NULL, 10)) < 1 || zoom > 16)) stop("no zoom", value);
	}
	if (!image) {
		fputs(USAGE, stderr);
		return WRONG_CALL;
	}
	for (int i = 0; i < shot_count; i++) if (shots[i].frame > last) last = shots[i].frame;

	struct mLogger logger = { .log = on_log };
	mLogSetDefaultLogger(&logger);
	struct mCore* core = mCoreFind(image);
	if (!core || !core->init(core)) stop("not an image", image);
	mCoreInitConfig(core, NULL);
	struct mCoreOptions options = { .useBios = false, .skipBios = true, .logLevel = mLOG_ALL };
	mCoreConfigLoadDefaults(&core->config, &options);
	core->desiredVideoDimensions(core, &width, &height);
	color_t* screen = calloc((size_t) width * height, sizeof *screen);
	if (!screen) stop("no memory", NULL);
	core->setVideoBuffer(core, screen, width);
	core->setAudioBufferSize(core, 1024);
	if (!mCoreLoadFile(core, image)) stop("cannot load", image);
	core->reset(core);

	int next = 0;
	for (long frame = 1; end < 0; frame++) {
		if (frame > frames) {
			fprintf(stderr, "gba-run: no line EXIT in %ld frames\n", frames);
			return NO_END;
		}
		while (next < press_count && presses[next].frame <= frame) core->setKeys(core, presses[next++].keys);
		core->runFrame(core);
		for (int i = 0; i < shot_count; i++)
			if (shots[i].frame == frame && end != CRASHED) write_png(shots[i].file, screen, width, height, zoom);
		if (last && frame >= last && end < 0) end = 0;
	}
	if (fflush(stdout)) stop("cannot write", "standard output");
	return end;
}
