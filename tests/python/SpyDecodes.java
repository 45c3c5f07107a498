import java.util.TreeMap;
import lcm.logging.Log;
import lcm.spy.LCMTypeDatabase;

/** Decodes an LCM event log as lcm-spy does, by the types of the class path: a line a channel, "CHANNEL type count". */
class SpyDecodes {
  public static void main(String[] arguments) throws Exception {
    LCMTypeDatabase types = new LCMTypeDatabase();
    TreeMap<String, Integer> decoded = new TreeMap<>();
    Log log = new Log(arguments[0], "r");
    while (true) {
      Log.Event event;
      try {
        event = log.readNext();
      } catch (java.io.EOFException end) {
        break;
      }
      long fingerprint = new java.io.DataInputStream(new java.io.ByteArrayInputStream(event.data)).readLong();
      Class<?> type = types.getClassByFingerprint(fingerprint);
      if (type == null) throw new IllegalStateException(event.channel + ": no type has fingerprint " + fingerprint);
      java.io.DataInput fields = new java.io.DataInputStream(new java.io.ByteArrayInputStream(event.data));
      type.getConstructor(java.io.DataInput.class).newInstance(fields);
      decoded.merge(event.channel + " " + type.getSimpleName(), 1, Integer::sum);
    }
    decoded.forEach((channel, count) -> System.out.println(channel + " " + count));
  }
}
