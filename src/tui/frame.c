/* Gathers what curses sends into one write per frame, and waits for terminals that draw slowly. */
#include "tui/frame.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char begin_mark[] = "\033[?2026h", end_mark[] = "\033[?2026l", question[] = "\033[5n";
enum {
    SENT_MAX = 6,  /* frames on their way on a fast line, however long */
    TELLING = 400, /* bytes of a frame that tells how fast the line is */
    ROOM = 1 << 20 /* bytes kept for one; a terminal of 400 x 200 in colour takes about that */
};
static const double fast = 0.1;     /* s such a frame may take beyond the way of an empty one */
static const double given_up = 3.0; /* s after which no answer is expected any more */

/* curses has one terminal, and so has this */
static struct {
    FILE *stream; /* of curses: its descriptor leads to the terminal, or to `file` in a frame */
    FILE *file;
    char *bytes;
    size_t size;
    bool asks, answers;
    struct sent {
        double at; /* s of the clock */
        size_t bytes;
    } sent[SENT_MAX]; /* frames without an answer, the oldest first */
    int n;
    double took;  /* s that the last frame which tells took to its answer */
    double least; /* s that any has taken: there and back */
} frame;

/* A file with room for a frame from the start: a disk that fills up later must not blank the
 * screen. NULL: there is no such room. */
static FILE *file_with_room(void) {
    FILE *file = tmpfile();
    if (file != NULL && posix_fallocate(fileno(file), 0, ROOM) != 0) {
        fclose(file);
        file = NULL;
    }
    return file;
}

FILE *cr_frame_open(bool asks) {
    memset(&frame, 0, sizeof frame);
    frame.asks = asks;
    frame.took = frame.least = INFINITY; /* not known yet */
    int fd = dup(STDOUT_FILENO);
    frame.file = file_with_room();
    frame.stream = fd >= 0 ? fdopen(fd, "w") : NULL;
    if (frame.stream == NULL && fd >= 0) {
        close(fd);
    }
    if (frame.stream == NULL || frame.file == NULL) {
        cr_frame_close();
    }
    return frame.stream;
}

void cr_frame_close(void) {
    if (frame.file != NULL) {
        fclose(frame.file);
    }
    if (frame.stream != NULL) {
        fclose(frame.stream);
    }
    free(frame.bytes);
    memset(&frame, 0, sizeof frame);
}

void cr_frame_begin(void) {
    if (frame.stream != NULL) {
        fflush(frame.stream);
        dup2(fileno(frame.file), fileno(frame.stream));
    }
}

static void send(const char *bytes, size_t n) {
    while (n > 0) {
        ssize_t done = write(STDOUT_FILENO, bytes, n);
        if (done >= 0) {
            bytes += done;
            n -= (size_t)done;
        } else if (errno == EAGAIN) { /* somebody has made the terminal non-blocking */
            struct pollfd fd = {.fd = STDOUT_FILENO, .events = POLLOUT};
            poll(&fd, 1, -1);
        } else if (errno != EINTR) {
            return;
        }
    }
}

/* room for so many bytes of a frame and what goes around it */
static bool make_room(size_t n) {
    n += sizeof begin_mark + sizeof end_mark + sizeof question;
    if (n > frame.size) {
        char *bigger = realloc(frame.bytes, 2 * n);
        if (bigger == NULL) {
            return false;
        }
        frame.bytes = bigger;
        frame.size = 2 * n;
    }
    return true;
}

static void put(size_t *n, const char *text) {
    memcpy(frame.bytes + *n, text, strlen(text));
    *n += strlen(text);
}

static void forget_oldest(void) {
    frame.n--;
    memmove(frame.sent, frame.sent + 1, (SENT_MAX - 1) * sizeof frame.sent[0]);
}

static void note_sent(double now, size_t bytes) {
    if (frame.n == SENT_MAX) {
        forget_oldest();
    }
    frame.sent[frame.n++] = (struct sent){now, bytes};
}

void cr_frame_end(double now) {
    if (frame.stream == NULL) {
        return;
    }
    fflush(frame.stream);
    int file = fileno(frame.file);
    off_t length = lseek(file, 0, SEEK_CUR);
    dup2(STDOUT_FILENO, fileno(frame.stream));
    if (length <= 0 || !make_room((size_t)length)) {
        return;
    }
    size_t n = 0;
    if (frame.asks) {
        put(&n, begin_mark);
    }
    ssize_t got = pread(file, frame.bytes + n, (size_t)length, 0);
    n += got > 0 ? (size_t)got : 0;
    if (frame.asks) {
        put(&n, end_mark);
    }
    if (frame.answers) {
        put(&n, question);
        note_sent(now, n);
    }
    lseek(file, 0, SEEK_SET);
    send(frame.bytes, n);
}

void cr_frame_ask(void) {
    if (frame.asks) {
        send(question, sizeof question - 1);
    }
}

void cr_frame_answered(double now) {
    frame.answers = true;
    if (frame.n > 0) {
        double took = now - frame.sent[0].at;
        if (frame.sent[0].bytes >= TELLING || took > frame.took) {
            frame.took = took;
        }
        frame.least = fmin(frame.least, took);
        forget_oldest();
    }
}

int cr_frame_awaits(double now) {
    double left = frame.n > 0 ? frame.sent[frame.n - 1].at + given_up - now : 0;
    return left > 0 ? (int)ceil(1e3 * left) : 0;
}

int cr_frame_wait(double now) {
    int most = frame.took < frame.least + fast ? SENT_MAX : 1;
    int wait = cr_frame_awaits(now);
    if (wait == 0) {
        frame.n = 0; /* they are lost */
    }
    return frame.n >= most ? wait : 0;
}
