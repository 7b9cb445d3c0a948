/* Who zeroes the torque when kiosk, servo or both fail in the midst of anything: the three parties of app/force/servo, by hand.
   A look of the guard and a tick of the servo are one step each; silence is counted in steps, so any order of them is tried.
   Either process dies or freezes at any moment; the guard, a thread of the kiosk, does so with it. */

/* What the model is broken by, to see that the claims can fail: spin -DNAME. */
#ifdef blind_guard
#define kills false
#else
#define kills true
#endif
#ifdef deaf_servo
#define listens false
#else
#define listens true
#endif
#ifdef hasty_guard
#define may_open (servo != alive && board != by_guard)
#else
#define may_open (servo == dead && board == nobody)
#endif

#define longest_silence 2
#define most_starts 2

mtype = { alive, frozen, dead };
mtype kiosk = alive;
mtype servo = dead;
mtype = { nobody, by_servo, by_guard };
mtype board = nobody;      /* who has it open: the kernel lets one */

bool torque = false;       /* the board keeps it, whoever dies */
bool kiosk_beat = false;   /* set by the guard, taken by the servo */
bool servo_beat = false;   /* set by the servo, taken by the guard */
bool is_connected = false; /* the socket between them */
byte starts = 0;
byte servo_life = 0;       /* a servo that was started again is another one */

#define guarded (kiosk == alive || servo == alive)

/* The servo: takes the board when it is free, ticks, and gives no torque to a kiosk that is silent or gone. */
proctype Servo(byte life) {
    byte silence = 0;
    bool is_armed = false;
    do
    :: atomic { servo_life != life || servo == dead -> break }
    :: atomic { servo_life == life && servo == alive && board == nobody -> board = by_servo; torque = false }
    :: atomic { servo_life == life && servo == alive && board == by_servo ->
        servo_beat = true;
        if
        :: kiosk_beat -> kiosk_beat = false; silence = 0
        :: else -> if :: silence < longest_silence -> silence++ :: else fi
        fi;
        if
        :: !is_connected || kiosk == dead -> /* HUP: zero, and the end */
            torque = false; board = nobody; servo = dead; is_armed = false; break
        :: else ->
            if
            :: listens && silence == longest_silence -> torque = false; is_armed = false
            :: silence == 0 && !is_armed -> is_armed = true
            :: silence == 0 && is_armed -> torque = true
            :: else
            fi
        fi }
    od
}

/* The guard: beats, looks for the servo's beat, kills a silent one, zeroes after a dead one, starts another. */
active proctype Guard() {
    byte silence = 0;
    do
    :: atomic { kiosk == dead -> break }
    :: atomic { kiosk == alive && servo != dead ->
        kiosk_beat = true;
        if
        :: servo_beat -> servo_beat = false; silence = 0
        :: else -> if :: silence < longest_silence -> silence++ :: else fi
        fi;
        if
        :: kills && silence == longest_silence && torque ->
            servo = dead; is_connected = false; /* SIGKILL; the kernel closes what it had open */
            if :: board == by_servo -> board = nobody :: else fi
        :: else
        fi }
    :: atomic { kiosk == alive && (torque || is_connected) && may_open -> board = by_guard }
    :: atomic { kiosk == alive && board == by_guard -> torque = false; is_connected = false; board = nobody }
    :: atomic { kiosk == alive && servo == dead && board == nobody && !torque && !is_connected && starts < most_starts ->
        starts++; servo_life = starts; servo = alive; servo_beat = false; kiosk_beat = false; silence = 0;
        is_connected = true; run Servo(starts) }
    od
}

/* What may happen to each of them once, at any moment. */
active proctype Fate() {
    bool is_kiosk_due = true, is_servo_due = true;
    do
    :: atomic { is_kiosk_due && kiosk == alive -> is_kiosk_due = false;
        if
        :: kiosk = frozen
        :: kiosk = dead; is_connected = false;
           if :: board == by_guard -> board = nobody :: else fi
        fi }
    :: atomic { is_servo_due && servo == alive -> is_servo_due = false;
        if
        :: servo = frozen
        :: servo = dead; if :: board == by_servo -> board = nobody :: else fi
        fi }
    :: atomic { kiosk == frozen -> kiosk = alive }
    :: break
    od
}

/* While one of the two still runs, torque that nobody renews ends. */
ltl zeroed { [] ((torque && (servo != alive || kiosk != alive)) -> <> (!torque || !guarded || (servo == alive && kiosk == alive))) }
/* The guard writes to the board only where no servo holds it. */
ltl one_writer { [] (board == by_guard -> servo == dead) }
/* A servo begins without torque. */
ltl begins_without { [] ((servo == alive && board == nobody) -> !torque) }
